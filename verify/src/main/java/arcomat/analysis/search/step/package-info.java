/**
 * The numbered steps of a configuration: collected, united, remembered, and split by what is sent.
 */
package arcomat.analysis.search.step;
