package arcomat.tree;

import arcomat.source.Span;

import java.util.List;

/** A stateless behaviour: the first row that matches decides. */
public record IoTable(
        Span span,
        List<Stereotype> stereotypes,
        List<Name> inputs,
        List<Name> outputs,
        List<Row> rows)
        implements Behaviour {
    @Override
    public List<Automaton> automata() {
        return List.of();
    }

    /** {@code | a | b | => | c |;}. */
    public record Row(Span span, List<Block.Value> inputs, List<Block.Value> outputs)
            implements Node {}
}
