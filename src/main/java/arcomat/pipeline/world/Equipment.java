package arcomat.pipeline.world;

import arcomat.pipeline.brick.PluggedDevices;
import arcomat.sim.load.Program;

/** What the brick of a robot is given: its program, and devices that a team has described. */
record Equipment(Program program, PluggedDevices devices) {}
