package arcomat.generate;

import arcomat.generate.text.LineMarks;
import arcomat.model.Automaton;
import arcomat.model.Component;

/**
 * Where in a generated file an automaton says what it has done, for those who look at its runs.
 *
 * @param className qualified name of the class that the file has
 * @param component that has the automaton
 * @param lines those of the file; none for a transition that the code does not have, since another
 *     one is always taken first
 */
public record AutomatonLines(
        String className, Component component, Automaton automaton, LineMarks lines) {}
