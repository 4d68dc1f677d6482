/**
 * What can be said about one file beside the findings: whether its promises are kept, its tests
 * pass and its automata have gaps, each at the place in the text that it is about.
 */
package arcomat.pipeline.verdict;
