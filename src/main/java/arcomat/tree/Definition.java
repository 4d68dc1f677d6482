package arcomat.tree;

import java.util.function.Function;

/** What a file is about. */
public sealed interface Definition extends Node
        permits Component, Automaton, ClassDiagram, TestSuite {
    /** Takes the sum apart: one answer for each form. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    record Cases<R>(
            Function<Component, R> component,
            Function<Automaton, R> automaton,
            Function<ClassDiagram, R> diagram,
            Function<TestSuite, R> suite) {}
}
