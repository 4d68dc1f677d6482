/**
 * One side of a comparison as a labelled transition system, given by its successor function: a
 * component, a composition, and both seen through held, late or hidden messages.
 */
package arcomat.analysis.search.system;
