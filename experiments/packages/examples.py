# SPDX-License-Identifier: BSD-3-Clause
"""Examples of man pages: what a command does, and the command. DATA is where flag files and worlds are."""

EXAMPLES = {
    "gmapping_spa": [
        ("A map, a trajectory and a pose graph of a log:",
         "gmapping_spa --log=robot.clf.gz --output_dir=out/robot --threads=4"),
        ("GMapping as its authors published it, with fewer particles:",
         "gmapping_spa --flagfile=DATA/flags/gmapping.flags --particles=10 --log=robot.clf.gz "
         "--output_dir=out/gmapping"),
        ("A page that shows the run while it goes:",
         "gmapping_spa --log=robot.clf.gz --output_dir=out/robot --view=live"),
        ("Two finished runs, side by side:", "gmapping_spa --view=out/robot,out/gmapping"),
    ],
    "inspect_log": [
        ("What a log holds, before a map is made of it:", "inspect_log --log=robot.clf.gz"),
    ],
    "edit_closures": [
        ("The results of a run whose loop closures were edited:",
         "edit_closures --session=robot.session --closures=out/robot/loop_closures.csv "
         "--output_dir=out/edited"),
    ],
    "convert_log": [
        ("A CARMEN log as a ROS 1 bag:",
         "convert_log --log=robot.clf.gz --output=robot.bag"),
    ],
    "optimize_graph": [
        ("The optimum of a pose graph, with a proof that it is the global one:",
         "optimize_graph --input=graph.g2o --output=optimized.g2o --certify"),
        ("How well each pose is known:",
         "optimize_graph --input=graph.g2o --covariances=covariances.csv"),
        ("The back ends there are, with their settings and losses:",
         "optimize_graph --list_backends"),
    ],
    "simulate": [
        ("A log of a robot in a building, with the true trajectory and map:",
         "simulate --world=DATA/worlds/paper_building.yaml --output_dir=out/simulated --seed=1"),
    ],
    "simulate_slam": [
        ("A map of a simulated building:",
         "simulate_slam --world=DATA/worlds/paper_building.yaml --output_dir=out/slam --seed=1"),
    ],
    "drive": [
        ("A page on which you drive a robot through a building while maps are made of it:",
         "drive --world=DATA/worlds/paper_building.yaml --output_dir=out/tour"),
        ("With the paper's obstacles and a pedestrian, twice as fast as real time:",
         "drive --world=DATA/worlds/paper_building.yaml --obstacles=DATA/worlds/paper_obstacles.yaml "
         "--walking_pedestrian --speed=2"),
    ],
    "evaluate_trajectory": [
        ("Errors of a trajectory:",
         "evaluate_trajectory --truth=out/simulated/truth.tum --trajectory=out/slam/trajectory.tum"),
    ],
    "evaluate_map": [
        ("Errors of a map, and a picture of them:",
         "evaluate_map --map=out/slam/map.yaml --trajectory=out/slam/trajectory.tum "
         "--truth=out/simulated/truth.yaml --truth_trajectory=out/simulated/truth.tum "
         "--error_map=errors.png"),
    ],
    "evaluate_relations": [
        ("The metric of the Freiburg benchmark:",
         "evaluate_relations --relations=intel.relations --trajectory=out/intel/trajectory.tum"),
    ],
}
