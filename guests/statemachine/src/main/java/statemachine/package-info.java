/**
 * Hierarchical state machines: states within states, what is done when they are entered and left,
 * and where a state goes on. A text is read ({@link statemachine.MachineReader}), looked at ({@link
 * statemachine.MachineLaws}), and written out as an automaton ({@link statemachine.Flattening}).
 */
package statemachine;
