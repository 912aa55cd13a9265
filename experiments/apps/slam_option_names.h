// SPDX-License-Identifier: BSD-3-Clause
// Names of the choices among SlamOptions, as flags and scripts have them.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_OPTION_NAMES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_OPTION_NAMES_H_

#include "backend/enum_names.h"
#include "frontend/api/slam_options.h"

namespace gmapping_spa::apps {

inline constexpr backend::EnumName<SlamOptions::Odometry> kOdometryNames[] = {
    {"raw", SlamOptions::Odometry::kRaw},
    {"wheel", SlamOptions::Odometry::kWheel},
    {"lidar", SlamOptions::Odometry::kLidar},
    {"lidar_only", SlamOptions::Odometry::kLidarOnly}};
inline constexpr backend::EnumName<SlamOptions::ScanMatcher> kScanMatcherNames[] = {
    {"hill_climbing", SlamOptions::ScanMatcher::kHillClimbing},
    {"gauss_newton", SlamOptions::ScanMatcher::kGaussNewton}};
inline constexpr backend::EnumName<SlamOptions::MatchStart> kMatchStartNames[] = {
    {"prediction", SlamOptions::MatchStart::kPrediction}, {"draw", SlamOptions::MatchStart::kDraw}};
inline constexpr backend::EnumName<SlamOptions::Proposal> kProposalNames[] = {
    {"gaussian", SlamOptions::Proposal::kGaussian}, {"match", SlamOptions::Proposal::kMatch}};
inline constexpr backend::EnumName<SlamOptions::Likelihood> kLikelihoodNames[] = {
    {"surface", SlamOptions::Likelihood::kSurface},
    {"nearest_hit", SlamOptions::Likelihood::kNearestHit}};
inline constexpr backend::EnumName<SlamOptions::MotionNoise> kMotionNoiseNames[] = {
    {"update", SlamOptions::MotionNoise::kUpdate}, {"scan", SlamOptions::MotionNoise::kScan}};
inline constexpr backend::EnumName<SlamOptions::EdgeMeasurement> kEdgeMeasurementNames[] = {
    {"lidar_odometry", SlamOptions::EdgeMeasurement::kLidarOdometry},
    {"particle", SlamOptions::EdgeMeasurement::kParticle}};
inline constexpr backend::EnumName<SlamOptions::EdgeInformation> kEdgeInformationNames[] = {
    {"proposal", SlamOptions::EdgeInformation::kProposal},
    {"hessian", SlamOptions::EdgeInformation::kHessian},
    {"constant", SlamOptions::EdgeInformation::kConstant}};
inline constexpr backend::EnumName<SlamOptions::GraphThread> kGraphThreadNames[] = {
    {"lockstep", SlamOptions::GraphThread::kLockstep},
    {"async", SlamOptions::GraphThread::kAsync},
    {"inline", SlamOptions::GraphThread::kInline}};
inline constexpr backend::EnumName<SlamOptions::Correction> kCorrectionNames[] = {
    {"pose", SlamOptions::Correction::kPose}, {"trajectory", SlamOptions::Correction::kTrajectory}};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_OPTION_NAMES_H_
