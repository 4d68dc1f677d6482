/** What several laws ask of a model, and how they word it. */
package arcomat.check.facts;
