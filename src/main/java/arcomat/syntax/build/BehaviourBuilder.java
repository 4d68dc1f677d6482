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
    private final Phrases phrases;
    private final AutomatonBuilder automata;

    BehaviourBuilder(Phrases phrases, AutomatonBuilder automata) {
        super(phrases.texts);
        this.phrases = phrases;
        this.automata = automata;
    }

    @Override
    public Behaviour visitAutomaton(AutomatonContext context) {
        return automata.automaton(context);
    }

    @Override
    public Behaviour visitIoTable(IoTableContext context) {
        return new IoTable(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                context.tableInputs() == null
                        ? List.of()
                        : phrases.names.buildAll(context.tableInputs().name()),
                context.tableOutputs() == null
                        ? List.of()
                        : phrases.names.buildAll(context.tableOutputs().name()),
                rows(context.row()));
    }

    private List<Row> rows(List<RowContext> contexts) {
        List<Row> rows = new ArrayList<>(contexts.size());
        for (RowContext row : contexts) {
            rows.add(
                    new Row(
                            span(row),
                            phrases.values.buildAll(row.inputs),
                            phrases.values.buildAll(row.outputs)));
        }
        return rows;
    }

    @Override
    public Behaviour visitImplementation(ImplementationContext context) {
        return new Implementation(
                span(context), phrases.names.buildOptional(context.name()), automata(context));
    }

    private List<Automaton> automata(ImplementationContext context) {
        if (!context.automatonElement().isEmpty()) {
            return List.of(bareAutomaton(context.automatonElement()));
        }
        List<Automaton> all = new ArrayList<>();
        for (AutomatonContext automaton : context.automaton()) {
            all.add(automata.automaton(automaton));
        }
        return all;
    }

    private Automaton bareAutomaton(List<AutomatonElementContext> elements) {
        Span span = span(elements.get(0).start, elements.get(elements.size() - 1).stop);
        return new Automaton(span, List.of(), Optional.empty(), automata.buildAll(elements));
    }
}
