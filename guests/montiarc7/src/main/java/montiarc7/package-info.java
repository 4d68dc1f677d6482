/**
 * Reads models of MontiArc 7 and writes Arcomat models that mean the same: {@code Folder} knows
 * what is there, {@code ComponentWriter} writes one component, {@code MachineWriter} its states.
 */
package montiarc7;
