/**
 * One side of a comparison as configurations with steps: a component, a composition, and both seen
 * through held, late or hidden messages.
 */
package arcomat.analysis.search.system;
