/**
 * Reads models of MontiArc 7 and writes Arcomat models that mean the same: {@code ComponentWriter}
 * writes one component, {@code MachineWriter} its states.
 */
package montiarc7;
