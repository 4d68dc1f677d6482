package arcomat.semantics.expression;

import arcomat.model.Expression;

/**
 * One of the conditions that have to hold together, so that a transition is enabled.
 *
 * @param asked as the model has it: a condition that may be undefined, or a value that has to be
 *     there
 * @param condition when it is fulfilled; always defined, as {@link Guards} makes it
 * @param text as the model writes it
 * @param effect whether it is about what outputs and assignments read
 */
public record Clause(Expression asked, Expression condition, String text, boolean effect) {}
