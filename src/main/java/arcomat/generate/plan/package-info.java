/**
 * What generated code does, before it is written: which transitions a state asks for, in which
 * order parts take their steps, what shares an array or a class. Writes nothing.
 */
package arcomat.generate.plan;
