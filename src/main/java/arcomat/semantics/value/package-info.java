/**
 * Which messages a model can tell apart: kinds of messages that stand for many, types with few
 * values, an order of values for those that are shown, and the limit above which nothing is
 * enumerated.
 */
package arcomat.semantics.value;
