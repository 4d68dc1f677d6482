/**
 * Whether requirements can be kept together, which of them cannot, and a controller that keeps
 * those that can.
 */
package arcomat.analysis.contradiction;
