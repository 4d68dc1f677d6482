/**
 * What others can see of a component: what it extends, its ports, parameters and constants. The
 * second step, as javac's MemberEnter; no body is looked into.
 */
package arcomat.symbols.signatures;
