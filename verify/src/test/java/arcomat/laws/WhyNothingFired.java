package arcomat.laws;

import arcomat.analysis.search.letter.Letters;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Refusal;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.WhyNot;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What is said not to have fired is what is not enabled; a clause to blame is one without which it
 * would be.
 */
final class WhyNothingFired implements Law {
    private static final int MOST_CONFIGURATIONS = 40;
    private static final int MOST_LETTERS = 200;

    @Override
    public String name() {
        return "9 why nothing fired";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        boolean events = draw.has(Features.EVENTS) && draw.chance(25);
        return List.of(
                ComponentText.types(),
                ComponentText.atomic(
                        draw, "a", "Main", ComponentText.plugs(draw, events), events, 1));
    }

    @Override
    public Outcome check(Models models) {
        StepRelation relation =
                ComponentSemantics.of(models.component(Pairs.LEFT), List.of()).relations().get(0);
        WhyNot whyNot = WhyNot.of(relation);
        Set<Configuration> seen = new LinkedHashSet<>();
        relation.starts().forEach(start -> seen.add(start.configuration()));
        List<Configuration> open = new ArrayList<>(seen);
        boolean met = false;
        for (int i = 0; i < open.size() && i < MOST_CONFIGURATIONS; i++) {
            Configuration before = open.get(i);
            for (Value[] letter : letters(relation, before)) {
                Input input = Input.of(letter);
                Optional<String> problem = problem(relation, whyNot, before, input);
                if (problem.isPresent()) {
                    return Outcome.broken(
                            problem.get() + " in " + before + " on " + List.of(input),
                            "simulate --why-not --main " + Pairs.LEFT);
                }
                met |= !whyNot.refusals(before, input).isEmpty();
                relation.prospect(before, input).reactions().stream()
                        .map(StepRelation.Reaction::next)
                        .filter(next -> next.isState() && seen.add(next))
                        .forEach(open::add);
            }
        }
        return met ? Outcome.KEPT : Outcome.SKIPPED;
    }

    private static List<Value[]> letters(StepRelation relation, Configuration before) {
        return Letters.of(relation.component(), relation.abstraction(before)).stream()
                .limit(MOST_LETTERS)
                .toList();
    }

    private static Optional<String> problem(
            StepRelation relation, WhyNot whyNot, Configuration before, Input input) {
        List<Refusal> refusals = whyNot.refusals(before, input);
        Set<Integer> told = new HashSet<>(enabled(relation, before, input));
        for (Refusal refusal : refusals) {
            if (!told.add(refusal.index())) {
                return Optional.of(refusal.arrow() + " is enabled, or told twice");
            }
        }
        for (int i = 0; i < relation.automaton().transitions().size(); i++) {
            boolean leaves = relation.automaton().transitions().get(i).source() == before.state();
            if (leaves != told.contains(i)) {
                return Optional.of("transition " + i + " is neither enabled nor refused");
            }
        }
        return refusals.stream()
                .flatMap(each -> problem(relation, each, before, input).stream())
                .findFirst();
    }

    private static Optional<String> problem(
            StepRelation relation, Refusal refusal, Configuration before, Input input) {
        List<Refusal.Clause> failed = refusal.failed();
        if (failed.isEmpty()) {
            return Optional.of("no clause is to blame: " + refusal.words());
        }
        for (int i = 0; i < refusal.clauses().size(); i++) {
            Refusal.Clause clause = refusal.clauses().get(i);
            if (clause.truth() == Refusal.Truth.TRUE) {
                continue;
            }
            StepRelation without = without(relation, refusal, i);
            boolean enabled = enabled(without, before, input).contains(refusal.index());
            // Without one effect the transition is tried without all of them.
            boolean alone =
                    failed.size() == 1
                            || clause.effect() && failed.stream().allMatch(Refusal.Clause::effect);
            if (enabled != alone || clause.because().isEmpty()) {
                return Optional.of(refusal.words() + ", but without " + clause + ": " + enabled);
            }
        }
        return Optional.empty();
    }

    private static List<Integer> enabled(StepRelation relation, Configuration before, Input input) {
        return relation.choices(before, input).enabled().stream().map(Trace.Taken::index).toList();
    }

    /** The automaton with one clause of one transition replaced by what is true. */
    private static StepRelation without(StepRelation relation, Refusal refusal, int clause) {
        List<Automaton.Transition> transitions =
                new ArrayList<>(relation.automaton().transitions());
        List<Automaton.Transition> before = relation.automaton().before(refusal.transition());
        int own = refusal.clauses().size() - before.size();
        if (clause < own) {
            transitions.set(refusal.index(), without(refusal.transition(), clause));
        } else {
            int rank = refusal.transition().rank();
            Automaton.Transition first = before.get(clause - own);
            transitions.replaceAll(each -> each == first ? first.withRank(rank) : each);
        }
        Component component = relation.component();
        Automaton changed = relation.automaton().withTransitions(transitions);
        return ComponentSemantics.of(component, List.of(changed), List.of()).relations().get(0);
    }

    private static Automaton.Transition without(Automaton.Transition from, int clause) {
        List<Automaton.Match> matches = new ArrayList<>(from.matches());
        List<Expression> conjuncts = new ArrayList<>();
        from.guard().ifPresent(guard -> addConjuncts(guard, conjuncts));
        boolean inGuard = clause >= matches.size() && clause < matches.size() + conjuncts.size();
        boolean inEffect = clause >= matches.size() + conjuncts.size();
        if (inGuard) {
            conjuncts.remove(clause - matches.size());
        } else if (!inEffect) {
            matches.remove(clause);
        }
        return from.with(
                conjuncts.stream().reduce(WhyNothingFired::and),
                matches,
                inEffect ? List.of() : from.sends(),
                inEffect ? List.of() : from.assignments());
    }

    private static void addConjuncts(Expression guard, List<Expression> conjuncts) {
        if (guard instanceof Expression.Binary both && both.operator() == BinaryOperator.AND) {
            addConjuncts(both.left(), conjuncts);
            addConjuncts(both.right(), conjuncts);
        } else {
            conjuncts.add(guard);
        }
    }

    private static Expression and(Expression left, Expression right) {
        return new Expression.Binary(BinaryOperator.AND, left, right, left.type(), left.span());
    }
}
