package arcomat.check.behaviour.automaton;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.tree.AutomatonElement.Transition;
import arcomat.tree.Block;
import arcomat.tree.Node;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** ARC0349: no transition is written twice; the second was meant to be another one. */
public final class TransitionOnce implements Check.OnAutomaton {

    /** What a transition says; blanks and the order of what happens at once aside. */
    private record Wording(
            String source,
            String target,
            String guard,
            Set<String> input,
            Set<String> output,
            String actions,
            int rank,
            int turn) {
        static Wording of(Transition transition) {
            return new Wording(
                    transition.source().text(),
                    transition.target().orElse(transition.source()).text(),
                    text(transition.guard().map(guard -> guard.condition())),
                    items(transition.input()),
                    items(transition.output()),
                    text(transition.actions()),
                    transition.rank(),
                    transition.turn());
        }

        private static Set<String> items(Optional<Block> block) {
            return block.map(Block::items).orElse(List.of()).stream()
                    .map(Wording::text)
                    .collect(Collectors.toSet());
        }

        private static String text(Optional<? extends Node> node) {
            return node.map(Wording::text).orElse("");
        }

        private static String text(Node node) {
            return node.span().text().strip().replaceAll("\\s+", " ");
        }
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        Duplicates.report(
                automaton.node().elements(Transition.class),
                Wording::of,
                (transition, first) ->
                        findings.report(
                                        transition,
                                        "this transition is written above already; correct one of"
                                                + " them, or delete this one")
                                .related(first, "the same transition"));
    }
}
