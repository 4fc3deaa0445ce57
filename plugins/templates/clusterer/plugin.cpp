#include <gestalt/core/plugin/plugin.h>

#include "my_component.h"

GESTALT_PLUGIN(gestalt::component<MyComponent>("my_component", "0.1.0", "Connected pixels of like normals"))
