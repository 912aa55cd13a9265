#include "backend/trajectory_io.h"
