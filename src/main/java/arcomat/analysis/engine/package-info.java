/**
 * The search behind the analyses: letters that look alike, numbered configurations with their
 * steps, and trace inclusion. Knows the step relation and nothing of the questions that are asked.
 */
package arcomat.analysis.engine;
