package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser.AutomatonContext;
import arcomat.syntax.antlr.ArcomatParser.AutomatonElementContext;
import arcomat.syntax.antlr.ArcomatParser.ImplementationContext;
import arcomat.syntax.antlr.ArcomatParser.IoTableContext;
import arcomat.syntax.antlr.ArcomatParser.RowContext;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;
import arcomat.tree.Behaviour.Implementation;
import arcomat.tree.IoTable;
import arcomat.tree.IoTable.Row;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Behaviour languages embedded in components: one method each. */
final class BehaviourBuilder extends TreeBuilder<Behaviour> {
    BehaviourBuilder(Builders builders) {
        super(builders);
    }

    @Override
    public Behaviour visitAutomaton(AutomatonContext context) {
        return builders.automata.automaton(context);
    }

    @Override
    public Behaviour visitIoTable(IoTableContext context) {
        return new IoTable(
                span(context),
                builders.stereotypes.stereotypes(context.stereotypes()),
                context.tableInputs() == null
                        ? List.of()
                        : builders.names.buildAll(context.tableInputs().name()),
                context.tableOutputs() == null
                        ? List.of()
                        : builders.names.buildAll(context.tableOutputs().name()),
                rows(context.row()));
    }

    private List<Row> rows(List<RowContext> contexts) {
        List<Row> rows = new ArrayList<>(contexts.size());
        for (RowContext row : contexts) {
            rows.add(
                    new Row(
                            span(row),
                            builders.values.buildAll(row.inputs),
                            builders.values.buildAll(row.outputs)));
        }
        return rows;
    }

    @Override
    public Behaviour visitImplementation(ImplementationContext context) {
        return new Implementation(
                span(context), builders.names.buildOptional(context.name()), automata(context));
    }

    private List<Automaton> automata(ImplementationContext context) {
        if (!context.automatonElement().isEmpty()) {
            return List.of(bareAutomaton(context.automatonElement()));
        }
        List<Automaton> automata = new ArrayList<>();
        for (AutomatonContext automaton : context.automaton()) {
            automata.add(builders.automata.automaton(automaton));
        }
        return automata;
    }

    private Automaton bareAutomaton(List<AutomatonElementContext> elements) {
        Span span = span(elements.get(0).start, elements.get(elements.size() - 1).stop);
        return new Automaton(
                span, List.of(), Optional.empty(), builders.automata.buildAll(elements));
    }
}
