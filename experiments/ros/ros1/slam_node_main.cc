// SPDX-License-Identifier: BSD-3-Clause
// A node for ROS 1 in place of slam_gmapping.
#include <ros/ros.h>

#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/ros/ros1/slam_node.h"
#include "experiments/ros/run_node.h"

namespace gmapping_spa::ros {
namespace {

std::string TextOf(const std::string& name, XmlRpc::XmlRpcValue value) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpc::XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      text << static_cast<double>(value);
      return text.str();
    case XmlRpc::XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    default:
      throw std::runtime_error("~" + name + ": expected a number, text, true or false");
  }
}

// The private parameters.
std::map<std::string, std::string> ParametersOf(const ::ros::NodeHandle& handle) {
  const std::string prefix = handle.getNamespace() + "/";
  std::vector<std::string> names;
  if (!handle.getParamNames(names)) throw std::runtime_error("cannot read the parameters");
  std::map<std::string, std::string> parameters;
  for (const std::string& path : names) {
    if (path.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string name = path.substr(prefix.size());
    XmlRpc::XmlRpcValue value;
    if (handle.getParam(path, value)) parameters[name] = TextOf(name, value);
  }
  return parameters;
}

void Run(const NodeParameters& parameters) {
  for (const std::string& line : parameters.refusals) ROS_WARN_STREAM(line);
  SlamNode(parameters.node).Spin();
}

}  // namespace
}  // namespace gmapping_spa::ros

int main(int argc, char** argv) {
  namespace node = gmapping_spa::ros;
  try {
    ros::init(argc, argv, "slam_gmapping", ros::init_options::NoSigintHandler);
    if (node::AsksForHelp(argc, argv)) return node::RunNode(argc, argv, {}, node::Run);
    const ros::NodeHandle handle("~");  // with the last handle, ROS shuts down
    return node::RunNode(argc, argv, node::ParametersOf(handle), node::Run);
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": error: " << error.what() << '\n';
    return 1;
  }
}
