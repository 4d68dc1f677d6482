package arcomat.laws;

import arcomat.analysis.refinement.Verdict;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.laws.draw.Plug;
import arcomat.model.Component;
import arcomat.semantics.network.Network;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What refines may stand wherever the other one may: {@code x.InA} for {@code x.InB}. */
final class ContextsKeepRefinement implements Law {

    private static final String LEFT = "component a.Main hole;";
    private static final String RIGHT = "component b.Main hole;";

    @Override
    public String name() {
        return "2 contexts keep refinement";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        boolean events = draw.has(Features.EVENTS) && draw.chance(15);
        List<Plug> plugs = ComponentText.plugs(draw, events);
        List<SourceFile> files = new ArrayList<>(Pairs.draw(draw, plugs, events));
        List<SourceFile> context = ComponentText.context(draw, "x", "InB", RIGHT, plugs, events);
        files.addAll(context);
        return files;
    }

    /** Whatever is wrong with the left side in the context is wrong with the right one, too. */
    @Override
    public Outcome check(Models models) {
        Component a = models.component(Pairs.LEFT);
        Component b = models.component(Pairs.RIGHT);
        if (interleaves(a, b)
                || !Questions.begins(b)
                || !Questions.holds(Questions.refines(a, b))) {
            return Outcome.SKIPPED;
        }
        Component inA = models.component("x.InA");
        Component inB = models.component("x.InB");
        Verdict verdict = Questions.refines(inA, inB);
        if (endsEarlier(a, b, verdict) || errsFirst(verdict, inA, inB)) {
            return Outcome.SKIPPED;
        }
        return Questions.fails(verdict)
                ? Outcome.broken(
                        "a context keeps no refinement: " + Questions.text(verdict),
                        Questions.command(Pairs.LEFT, Pairs.RIGHT) + ": holds",
                        Questions.command("x.InA", "x.InB") + ": fails")
                : Outcome.KEPT;
    }

    /**
     * Among events, parts of compositions take turns with their neighbours, and another queue
     * overflows at another time: {@code docs/semantics.md} promises nothing about contexts of
     * these.
     */
    private static boolean interleaves(Component a, Component b) {
        return a.profile() == Component.Profile.EVENT_DRIVEN
                && (isComposition(a) || isComposition(b) || a.queueCapacity() != b.queueCapacity());
    }

    private static boolean isComposition(Component component) {
        return component.body() instanceof Component.Composite;
    }

    /**
     * Where a neighbour errs, a message that has passed through a part without delay is not seen,
     * and one that was sent a slice before is: no definition of what an error shows could hide that
     * from the outside. The same goes for a message that is only passed on, and for a part whose
     * automata contradict each other in that slice: it has no run that goes on.
     */
    private static boolean endsEarlier(Component a, Component b, Verdict verdict) {
        boolean mixed = verdict.notes().stream().anyMatch(n -> n.contains("different delays"));
        return Questions.fails(verdict)
                && (mixed || passesOn(a) || passesOn(b))
                && (endsInError(verdict) || hasSeveralAutomata(a));
    }

    /** Whether an input is connected straight to an output. */
    private static boolean passesOn(Component whole) {
        Network network = Network.of(whole, List.of());
        return network.outputs().stream()
                .anyMatch(
                        out ->
                                network.inputs().stream()
                                        .anyMatch(in -> in.signal() == out.signal()));
    }

    /**
     * Where one part errs and another one allows nothing, the first of them decides whether there
     * is a run that ends, and a composition may have both inside or one of them.
     */
    private static boolean errsFirst(Verdict verdict, Component left, Component right) {
        return Questions.fails(verdict)
                && (hasSeveralAutomata(left) || hasSeveralAutomata(right))
                && endsInError(verdict);
    }

    private static boolean hasSeveralAutomata(Component whole) {
        return Network.of(whole, List.of()).instances().stream()
                .anyMatch(part -> part.component().automata().size() > 1);
    }

    private static boolean endsInError(Verdict verdict) {
        return verdict.trace().get(verdict.trace().size() - 1).error();
    }

    /** The context of the left side is made from that of the right one. */
    @Override
    public Optional<Outcome> checkText(List<SourceFile> files, int seed) {
        Optional<SourceFile> inA =
                files.stream()
                        .filter(f -> f.path().equals("x/InB.arc") && f.text().contains(RIGHT))
                        .findFirst()
                        .map(ContextsKeepRefinement::aroundA);
        if (inA.isEmpty()) {
            return Optional.empty();
        }
        List<SourceFile> both = new ArrayList<>(files);
        both.add(inA.get());
        Optional<Models> models = Models.read(both, seed);
        Optional<Outcome> outcome =
                models.isPresent()
                        ? models.map(this::check)
                        : Models.read(files, seed).map(ContextsKeepRefinement::misfit);
        return outcome.map(o -> o.with(inA.get().path(), inA.get().text()));
    }

    private static SourceFile aroundA(SourceFile whole) {
        return new SourceFile(
                whole.path().replace("InB", "InA"),
                whole.text().replace("component InB ", "component InA ").replace(RIGHT, LEFT));
    }

    /** A context that takes the right side and not the left one, though that refines it. */
    private static Outcome misfit(Models right) {
        Component a = right.component(Pairs.LEFT);
        Component b = right.component(Pairs.RIGHT);
        return !interleaves(a, b) && Questions.holds(Questions.refines(a, b))
                ? Outcome.broken(
                        "a context does not take what refines",
                        Questions.command(Pairs.LEFT, Pairs.RIGHT) + ": holds",
                        "check: x.InA has errors, x.InB has none")
                : Outcome.SKIPPED;
    }
}
