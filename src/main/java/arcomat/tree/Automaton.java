package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** An I/O-omega automaton, embedded in a component or a file of its own. */
public record Automaton(
        Span span,
        List<Stereotype> stereotypes,
        Optional<Name> name,
        List<AutomatonElement> elements)
        implements Definition, Behaviour {
    @Override
    public List<Automaton> automata() {
        return List.of(this);
    }

    /** The elements of one kind, in text order. */
    public <E extends AutomatonElement> List<E> elements(Class<E> kind) {
        return Node.ofKind(kind, elements);
    }

    @Override
    public <R> R match(Cases<R> cases) {
        return cases.automaton().apply(this);
    }
}
