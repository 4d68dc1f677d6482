package arcomat.generate.views;

import arcomat.generate.plan.AutomatonPlan;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.Formula;
import arcomat.generate.text.FormulaBuilder;
import arcomat.generate.view.AtomicView.LineView;
import arcomat.generate.view.AtomicView.StatementsView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.statement.Procedure;
import arcomat.semantics.statement.Step;

import java.util.ArrayList;
import java.util.List;

/** Statements of an effect, line by line. */
final class StatementViews implements Step.Cases<Void> {
    private final FileContext context;
    private final Automaton automaton;
    private final Effects effects;
    private final ExpressionWriter text;
    private final Procedure procedure;
    private final int index;
    private final boolean counts;
    private final List<LineView> lines = new ArrayList<>();
    private int depth;

    /**
     * @param traced whether the number of the way that is gone is counted
     */
    StatementViews(
            FileContext context,
            Automaton automaton,
            Effects effects,
            AutomatonPlan.Way way,
            boolean traced) {
        AutomatonPlan.Block block = way.block().orElseThrow();
        this.context = context;
        this.automaton = automaton;
        this.effects = effects;
        this.procedure = block.procedure();
        this.index = way.index();
        this.counts = traced && way.transition().body().orElseThrow().isNumbered();
        this.text =
                context.expressions()
                        .at(Fault.place(context.component(), automaton, way.transition()));
    }

    StatementsView view() {
        freely();
        procedure.locals().forEach(this::declare);
        all(procedure.steps());
        String label = procedure.stops() ? label() : "";
        return new StatementsView(lines, label, counts ? way() : "");
    }

    /** What is sent where statements say nothing of a port on which something has to be sent. */
    private void freely() {
        if (automaton.omitted() == Automaton.Omitted.FREE && !context.isEventDriven()) {
            context.component().outputs().stream()
                    .filter(Port::total)
                    .map(port -> new Step.Emit(port, new Automaton.AnyMessage()))
                    .forEach(this::emit);
        }
    }

    private String label() {
        return context.members().local("statements", index);
    }

    private String way() {
        return context.members().local("way");
    }

    private void all(List<Step> steps) {
        steps.forEach(each -> each.match(this));
    }

    private void line(String kind, String type, String target, String value) {
        lines.add(new LineView(kind, depth, type, target, value));
    }

    @Override
    public Void declare(Step.Declare declare) {
        line(
                "declare",
                text.type(declare.cell().type()),
                text.of(declare.cell()).text(),
                text.of(declare.value()).text());
        return null;
    }

    @Override
    public Void set(Step.Set set) {
        line("assign", "", text.of(set.cell()).text(), text.of(set.value()).text());
        return null;
    }

    @Override
    public Void keep(Step.Keep keep) {
        String value = text.inRange(keep.value(), keep.wanted(), keep.name()).text();
        line("assign", "", text.of(keep.cell()).text(), value);
        return null;
    }

    @Override
    public Void emit(Step.Emit emit) {
        boolean events = context.isEventDriven();
        List<AssignmentView> all =
                events
                        ? effects.calls(text, emit.port(), emit.emission())
                        : effects.emitted(text, emit.port(), emit.emission());
        all.forEach(each -> line(events ? "call" : "assign", "", each.target(), each.value()));
        return null;
    }

    @Override
    public Void choose(Step.Choose choose) {
        Formula condition = formula(choose.condition());
        if (choose.then().isEmpty() && choose.otherwise().isEmpty() && !condition.mayFail()) {
            return null;
        }
        if (choose.then().isEmpty() && !choose.otherwise().isEmpty()) {
            line("if", "", "", text.of(formula(negated(choose.condition()))).text());
            inside(choose.otherwise());
        } else {
            line("if", "", "", text.of(condition).text());
            inside(choose.then());
            otherwise(choose.otherwise());
        }
        line("end", "", "", "");
        return null;
    }

    private void inside(List<Step> steps) {
        depth++;
        all(steps);
        depth--;
    }

    /** A choice that is all there is behind {@code else} stands beside it. */
    private void otherwise(List<Step> steps) {
        if (steps.size() == 1
                && steps.get(0) instanceof Step.Choose next
                && !next.then().isEmpty()) {
            line("elseif", "", "", text.of(formula(next.condition())).text());
            inside(next.then());
            otherwise(next.otherwise());
        } else if (!steps.isEmpty()) {
            line("else", "", "", "");
            inside(steps);
        }
    }

    private Formula formula(Expression condition) {
        return new FormulaBuilder(text).of(condition);
    }

    @Override
    public Void need(Step.Need need) {
        Formula condition = formula(need.condition());
        if (condition.equals(Formula.FALSE)) {
            line("stop", "", "", "");
            return null;
        }
        line("if", "", "", text.of(formula(negated(need.condition()))).text());
        depth++;
        line("stop", "", "", "");
        depth--;
        line("end", "", "", "");
        return null;
    }

    private static Expression negated(Expression e) {
        return new Expression.Unary(Expression.UnaryOperator.NOT, e, e.type(), e.span());
    }

    @Override
    public Void count(Step.Count count) {
        line("count", "", way(), String.valueOf(count.more()));
        return null;
    }
}
