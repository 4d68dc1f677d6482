package arcomat.check.behaviour.action;

import arcomat.check.behaviour.action.MessageReads.Held;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.Block;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Where statements read messages that may not be there, and what they keep or send. A name stands
 * for what was assigned to it last; what is overwritten before somebody reads it counts for
 * nothing.
 */
final class StatementReads implements ActionSymbol.Cases<StatementReads> {
    /** One side of a choice. */
    record Branch(ActionSymbol.Choose choice, boolean then) {
        boolean excludes(Branch other) {
            return choice == other.choice && then != other.then;
        }
    }

    /**
     * A read of messages that may not be there, in a condition or in what is kept or sent.
     *
     * @param action whose condition or value it is
     * @param branches around it, outermost first
     * @param ports that may be silent, in text order
     * @param presence what it tells of them
     */
    record Read(
            ActionSymbol action,
            TypedExpression value,
            List<Branch> branches,
            Set<PortSymbol> ports,
            KnownMessages presence) {
        boolean isCondition() {
            return action instanceof ActionSymbol.Choose;
        }

        /** Whether it asks itself whether one of the messages is there. */
        boolean asksFor(List<PortSymbol> asked) {
            boolean[] asks = {false};
            value.walk(
                    part ->
                            asks[0] |=
                                    part instanceof TypedExpression.Absence absence
                                            && asked.contains(absence.port()));
            return asks[0];
        }

        /** Whether what is done on a branch is not done together with this. */
        boolean excludes(Branch branch) {
            return branches.stream().anyMatch(each -> each.excludes(branch));
        }
    }

    /**
     * Something that is kept or sent.
     *
     * @param needed ports that it reads, or that its conditions have read
     */
    record Effect(ActionSymbol.Assign action, List<Branch> branches, Set<PortSymbol> needed) {}

    /** What was assigned to a name, with the reads in it that count if somebody looks at it. */
    private record Value(Held held, List<Branch> branches, Set<Read> reads) {}

    private final Set<Read> reads = new LinkedHashSet<>();
    private final List<Effect> effects = new ArrayList<>();
    private final List<ActionSymbol> single = new ArrayList<>();
    private Map<ValueSymbol, Value> values = new LinkedHashMap<>();
    private List<Branch> branches = List.of();
    private Set<PortSymbol> there = Set.of();

    private StatementReads() {}

    /** What statements read and do. */
    static StatementReads of(ActionSymbol actions) {
        return actions.match(new StatementReads()).withWhatIsKept();
    }

    private StatementReads withWhatIsKept() {
        values.forEach(
                (name, value) -> {
                    if (isKept(name)) {
                        reads.addAll(value.reads());
                    }
                });
        return this;
    }

    /** In text order of what they count for. */
    List<Read> reads() {
        return List.copyOf(reads);
    }

    List<Effect> effects() {
        return List.copyOf(effects);
    }

    /** Whether it is a statement among others in braces, and not a side of a choice itself. */
    boolean standsInBraces(ActionSymbol action) {
        return single.stream().noneMatch(each -> each == action);
    }

    /** Whether a side of a choice reads a port that only its condition has asked for. */
    boolean readsBehind(ActionSymbol.Choose choice, PortSymbol port) {
        return choice.otherwise().stream()
                .flatMap(each -> of(each).reads().stream())
                .anyMatch(each -> each.ports().contains(port));
    }

    private static boolean isKept(ValueSymbol name) {
        return !(name instanceof VariableSymbol variable)
                || variable.kind() != VariableSymbol.Kind.LOCAL;
    }

    @Override
    public StatementReads sequence(ActionSymbol.Sequence sequence) {
        sequence.actions().forEach(each -> each.match(this));
        return this;
    }

    @Override
    public StatementReads declare(ActionSymbol.Declare declare) {
        for (ActionSymbol.Local local : declare.locals()) {
            VariableSymbol name = local.variable();
            Optional<TypedExpression> initial = name.initial().map(Typed::expression);
            initial.ifPresent(this::look);
            values.put(
                    name,
                    new Value(initial.map(this::held).orElse(Held.NOTHING), branches, Set.of()));
        }
        return this;
    }

    @Override
    public StatementReads assign(ActionSymbol.Assign assign) {
        ItemSymbol item = assign.item();
        Optional<ValueSymbol> target = item.target().found();
        if (target.isPresent()) {
            assign(assign, target.get(), item.value().expressions());
        }
        return this;
    }

    private void assign(ActionSymbol.Assign assign, ValueSymbol target, List<Typed> written) {
        Set<Read> found = new LinkedHashSet<>();
        Set<PortSymbol> all = new HashSet<>(there);
        Held held = Held.NOTHING;
        for (Typed each : written) {
            TypedExpression value = each.expression();
            look(value);
            held = held(value);
            all.addAll(held.all());
            Set<PortSymbol> open = messages().open(value, there);
            if (!open.isEmpty()) {
                found.add(new Read(assign, value, branches, open, KnownMessages.of(open)));
            }
        }
        if (isKept(target)) {
            if (!(assign.item().value().node() instanceof Block.NoMessage)) {
                effects.add(new Effect(assign, branches, Set.copyOf(all)));
            }
            held = held.counted();
        }
        values.put(target, new Value(held, branches, found));
    }

    private Held held(TypedExpression value) {
        MessageReads reads = messages();
        return new Held(
                reads.all(value),
                reads.open(value, there),
                reads.unguarded(value, there),
                reads.presence(value));
    }

    private MessageReads messages() {
        return new MessageReads(
                name -> {
                    Value value = values.get(name);
                    return value == null ? Held.NOTHING : value.held();
                });
    }

    /** Somebody reads what names hold, so the reads in that count. */
    private void look(TypedExpression value) {
        value.walk(
                part -> {
                    if (part instanceof TypedExpression.VariableRead read
                            && values.containsKey(read.variable())) {
                        Value held = values.get(read.variable());
                        if (!isInside(held.branches())) {
                            reads.addAll(held.reads());
                        }
                    }
                });
    }

    private boolean isInside(List<Branch> around) {
        return branches.size() >= around.size()
                && branches.subList(0, around.size()).equals(around);
    }

    @Override
    public StatementReads choose(ActionSymbol.Choose choice) {
        TypedExpression condition = choice.condition().expression();
        look(condition);
        MessageReads messages = messages();
        Set<PortSymbol> ports = messages.unguarded(condition, there);
        KnownMessages told = messages.presence(condition);
        if (!ports.isEmpty()) {
            reads.add(new Read(choice, condition, branches, ports, told));
        }
        Map<ValueSymbol, Value> before = values;
        Map<ValueSymbol, Value> then =
                after(choice, true, Optional.of(choice.then()), told.whenTrue(), before);
        Map<ValueSymbol, Value> otherwise =
                after(choice, false, choice.otherwise(), told.whenFalse(), before);
        values = merged(then, otherwise);
        return this;
    }

    private Map<ValueSymbol, Value> after(
            ActionSymbol.Choose choice,
            boolean isThen,
            Optional<ActionSymbol> side,
            Set<PortSymbol> told,
            Map<ValueSymbol, Value> before) {
        List<Branch> around = branches;
        Set<PortSymbol> thereBefore = there;
        values = new LinkedHashMap<>(before);
        branches = new ArrayList<>(around);
        branches.add(new Branch(choice, isThen));
        there = KnownMessages.all(there, told);
        side.filter(each -> !(each instanceof ActionSymbol.Sequence)).ifPresent(single::add);
        side.ifPresent(each -> each.match(this));
        branches = around;
        there = thereBefore;
        return values;
    }

    private static Map<ValueSymbol, Value> merged(
            Map<ValueSymbol, Value> then, Map<ValueSymbol, Value> otherwise) {
        Map<ValueSymbol, Value> all = new LinkedHashMap<>(then);
        otherwise.forEach((name, value) -> all.merge(name, value, StatementReads::merged));
        return all;
    }

    /** What is the one or the other; what a side reads counts where that side assigns it. */
    private static Value merged(Value then, Value otherwise) {
        if (then == otherwise) {
            return then;
        }
        Set<Read> reads = new LinkedHashSet<>(then.reads());
        reads.addAll(otherwise.reads());
        return new Value(
                then.held().either(otherwise.held()),
                then.branches().size() > otherwise.branches().size()
                        ? then.branches()
                        : otherwise.branches(),
                reads);
    }
}
