package arcomat.check.behaviour.action;

import arcomat.check.behaviour.action.StatementReads.Branch;
import arcomat.check.behaviour.action.StatementReads.Effect;
import arcomat.check.behaviour.action.StatementReads.Read;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Span;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Behaviour;
import arcomat.tree.Expression;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * ARC0355: a message that only a part of {@code compute} reads is asked for first. Where it is not
 * there, no way through the statements is open, and what does not need it is not done either.
 */
public final class SilenceStaysInBranch implements Check.OnActions {

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        if (context.side().equals(Optional.of(Side.OUTPUT))
                && isComputed(context)
                && areSound(actions)) {
            StatementReads reads = StatementReads.of(actions);
            Map<Read, List<PortSymbol>> silencing = silencing(reads);
            silencing.forEach(
                    (read, ports) -> report(read, ports, reads, silencing, context, findings));
        }
    }

    private static boolean isComputed(Context context) {
        Optional<AutomatonSymbol> automaton = context.automaton();
        return automaton.flatMap(AutomatonSymbol::component).map(ComponentSymbol::node).stream()
                .flatMap(node -> node.elements(Behaviour.Computation.class).stream())
                .anyMatch(each -> each.automaton() == automaton.get().node());
    }

    /** Whether no other law tells of what is read here, so that nothing follows from that. */
    private static boolean areSound(ActionSymbol actions) {
        return actions.choices().stream()
                        .map(ActionSymbol.Choose::condition)
                        .allMatch(each -> each.problems().isEmpty() && each.type().isBoolean())
                && actions.items().stream()
                        .flatMap(each -> each.value().expressions().stream())
                        .allMatch(each -> each.problems().isEmpty());
    }

    /** The reads that keep something else from being done, each with the ports that do. */
    private static Map<Read, List<PortSymbol>> silencing(StatementReads reads) {
        Map<Read, List<PortSymbol>> silencing = new LinkedHashMap<>();
        for (Read read : reads.reads()) {
            List<PortSymbol> ports =
                    read.ports().stream()
                            .filter(port -> lost(read, port, reads).isPresent())
                            .toList();
            if (!ports.isEmpty()) {
                silencing.put(read, ports);
            }
        }
        return silencing;
    }

    /**
     * What may be done together with a read, does not need the message, and does not come to it.
     */
    private static Optional<Effect> lost(Read read, PortSymbol port, StatementReads reads) {
        Optional<List<Branch>> waiting = waiting(read, port, reads);
        return reads.effects().stream()
                .filter(effect -> !effect.needed().contains(port))
                .filter(effect -> effect.branches().stream().noneMatch(read::excludes))
                .filter(
                        effect ->
                                waiting.map(around -> !isIn(effect.branches(), around))
                                        .orElseGet(() -> !isDecidedBy(effect, read)))
                .findFirst();
    }

    /** The outermost statements around a read that need the message anyway, choices apart. */
    private static Optional<List<Branch>> waiting(
            Read read, PortSymbol port, StatementReads reads) {
        return reads.reads().stream()
                .filter(each -> !each.isCondition())
                .filter(each -> each.ports().contains(port))
                .map(Read::branches)
                .filter(around -> isIn(read.branches(), around))
                .min((some, other) -> some.size() - other.size());
    }

    private static boolean isIn(List<Branch> branches, List<Branch> around) {
        return branches.size() >= around.size()
                && branches.subList(0, around.size()).equals(around);
    }

    private static boolean isDecidedBy(Effect effect, Read condition) {
        return effect.branches().stream().anyMatch(each -> each.choice() == condition.action());
    }

    private static void report(
            Read read,
            List<PortSymbol> ports,
            StatementReads reads,
            Map<Read, List<PortSymbol>> silencing,
            Context context,
            Findings findings) {
        Effect lost = lost(read, ports.get(0), reads).orElseThrow();
        Repair repair = Repair.of(read, ports, reads);
        String completion =
                context.automaton().orElseThrow().stereotype("completion").orElse("chaos");
        findings.report(
                        read.value().node(),
                        "this %s a message on %s; without one nothing in this 'compute' is done,"
                                + " and '%s' is left to completion '%s' as well; %s",
                        read.presence().always().containsAll(ports) ? "needs" : "may need",
                        ports.stream()
                                .map(port -> "'" + port.name() + "'")
                                .collect(Collectors.joining(" and ")),
                        name(lost),
                        completion,
                        repair.advice())
                .related(lost.action().node(), "this needs no " + Wording.quoted(names(ports)));
        if (areAllFound(ports, reads, silencing)) {
            repair.fix().ifPresent(findings::fix);
        }
    }

    private static List<String> names(List<PortSymbol> ports) {
        return ports.stream().map(PortSymbol::name).toList();
    }

    private static String name(Effect effect) {
        return effect.action().item().target().found().orElseThrow().name();
    }

    /** Whether no read that is no trouble now becomes one when this one is repaired. */
    private static boolean areAllFound(
            List<PortSymbol> ports, StatementReads reads, Map<Read, List<PortSymbol>> silencing) {
        return reads.reads().stream()
                .allMatch(
                        read ->
                                ports.stream()
                                        .filter(read.ports()::contains)
                                        .allMatch(
                                                port ->
                                                        silencing
                                                                .getOrDefault(read, List.of())
                                                                .contains(port)));
    }

    /**
     * Asks for the messages first.
     *
     * @param advice what to do, in words
     * @param fix what does it, if that changes nothing where the messages are there
     */
    private record Repair(String advice, Optional<Fix> fix) {
        static Repair of(Read read, List<PortSymbol> ports, StatementReads reads) {
            String there =
                    ports.stream()
                            .map(port -> port.name() + " != --")
                            .collect(Collectors.joining(" && "));
            return read.action() instanceof ActionSymbol.Choose choice
                    ? ofCondition(read, choice, there, ports, reads)
                    : ofValue(read, there, ports, reads);
        }

        private static Repair ofValue(
                Read read, String there, List<PortSymbol> ports, StatementReads reads) {
            String question = "if (" + there + ")";
            Span span = read.action().node().span();
            if (read.asksFor(ports)) {
                return new Repair(
                        "decide by '" + question + " .. else ..' what is kept or sent",
                        Optional.empty());
            }
            return reads.standsInBraces(read.action())
                    ? new Repair(
                            "write '" + question + "' before it",
                            Optional.of(
                                    Fix.replace(
                                            "Insert '" + question + "'",
                                            span,
                                            question + " " + span.text())))
                    : new Repair("write '{ " + question + " .. }' around it", Optional.empty());
        }

        private static Repair ofCondition(
                Read read,
                ActionSymbol.Choose choice,
                String there,
                List<PortSymbol> ports,
                StatementReads reads) {
            if (!read.presence().whenTrue().containsAll(ports)) {
                return new Repair("ask '" + there + "' before what reads it", Optional.empty());
            }
            Expression condition = read.value().node();
            String text = condition.span().text();
            String asked = there + " && " + (bindsLess(condition) ? "(" + text + ")" : text);
            return new Repair(
                    "write '" + asked + "'",
                    Optional.of(Fix.replace("Change to '" + asked + "'", condition.span(), asked))
                            .filter(
                                    fix ->
                                            ports.stream()
                                                    .noneMatch(
                                                            port ->
                                                                    reads.readsBehind(
                                                                            choice, port))));
        }

        private static boolean bindsLess(Expression condition) {
            if (condition instanceof Expression.Binary binary) {
                return switch (binary.operator()) {
                    case OR, IMPLIES, EQUIVALENT -> true;
                    default -> false;
                };
            }
            return condition instanceof Expression.Let || reachesFar(condition);
        }

        private static boolean reachesFar(Expression condition) {
            return condition instanceof Expression.Conditional
                    || condition instanceof Expression.Quantified;
        }
    }
}
