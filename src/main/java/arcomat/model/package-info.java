/**
 * What was meant: components with concrete types, automata with typed expressions, stream tests and
 * traces, as immutable data. Texts are known only as places to point at; nothing here runs.
 */
package arcomat.model;
