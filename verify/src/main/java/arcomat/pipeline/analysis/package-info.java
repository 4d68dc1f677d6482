/**
 * The questions about automata, from names on the command line to verdicts; also asks MONA. Decides
 * nothing itself: that is the analyses' work.
 */
package arcomat.pipeline.analysis;
