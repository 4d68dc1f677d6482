package arcomat.live;

import arcomat.analysis.search.Budget;
import arcomat.diagram.AutomatonGraph;
import arcomat.diagram.ComponentGraph;
import arcomat.diagram.Graph;
import arcomat.live.picture.Drawing;
import arcomat.model.Component;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.source.SourceFile;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What lies open on the page, and everything that is asked about it. Answers are JSON; one with a
 * field {@code refused} says in a sentence why there is none.
 */
public final class Desk {
    /** As many configurations as a page should hold. */
    private static final long MOST_STATES = 300_000;

    private static final int DEPTH = 2;

    private static final String WITH_ERRORS =
            ModelAnswers.refusal("there are errors in the models; repair them first");

    private ReadTexts read = ReadTexts.NONE;
    private OpenWorlds worlds = OpenWorlds.NONE;
    private @Nullable OpenModels models;
    private @Nullable Drawing drawing;

    /** A question that may turn out to be none. */
    private interface Asking {
        String of(LoweredModels models) throws WrongUse;
    }

    /**
     * Reads the texts, models and worlds, and tells what is found in them; what is asked later is
     * asked of them.
     *
     * @param needed paths of those that only lie around the others
     */
    public String check(String[] paths, String[] texts, String[] needed) {
        List<SourceFile> files = new ArrayList<>();
        for (int i = 0; i < paths.length; i++) {
            files.add(new SourceFile(paths[i], texts[i]));
        }
        worlds = OpenWorlds.among(files);
        files.removeIf(OpenWorlds::isWorld);
        read = read.with(files);
        models = OpenModels.read(read, Set.copyOf(Arrays.asList(needed)));
        return ModelAnswers.findings(models, worlds.findings());
    }

    /** Of what was checked last, all that can be drawn. */
    public String components() {
        return models == null ? WITH_ERRORS : ModelAnswers.components(models.shown());
    }

    /**
     * What could be written at a place.
     *
     * @param text of the file as it is now, which may be newer than what was checked
     */
    public String complete(String path, String text, int offset) {
        SourceFile file = new SourceFile(path, text);
        return OpenWorlds.isWorld(file)
                ? WordAnswers.offers(file, offset, new OpenPrograms(path, models))
                : WordAnswers.offers(read, file, offset);
    }

    /** What is known of the name at a place; an empty object where there is none. */
    public String facts(String path, int offset) {
        return WordAnswers.facts(read, path, offset);
    }

    public String refines(String left, String right, double milliseconds) {
        return ask(lowered -> proofs(lowered, milliseconds).refines(left, right));
    }

    public String verify(double milliseconds) {
        return ask(lowered -> proofs(lowered, milliseconds).verify());
    }

    public String analyze(double milliseconds) {
        return ask(lowered -> proofs(lowered, milliseconds).analyze());
    }

    /** Runs all stream tests. */
    public String test() {
        return ask(TestAnswers::of);
    }

    public String contradictions(String component, double milliseconds) {
        return ask(lowered -> proofs(lowered, milliseconds).contradictions(component));
    }

    /**
     * A run over the letters; where it comes to a choice that nobody has made it says so.
     *
     * @param letters a text per step, a line per message
     */
    public String run(String component, String[] letters, int[] choices) {
        return ask(lowered -> aRun(lowered, component, letters, choices).answer());
    }

    /** The same run as the text of a stream test; not JSON. */
    public String record(String component, String[] letters, int[] choices, String suite) {
        return ask(lowered -> aRun(lowered, component, letters, choices).suite(suite));
    }

    /** A run of a world, with its robots' models for their programs. */
    public String floor(String world, int seed) {
        return ask(lowered -> worlds.run(world, seed, lowered));
    }

    /**
     * What the page's engine is to place for a picture. Errors elsewhere are no matter.
     *
     * @param automaton which of its automata; the component with its parts if negative
     * @param closed paths of parts that do not show what is inside
     */
    public String graph(String component, int automaton, String[] closed) {
        return models == null
                ? WITH_ERRORS
                : answer(
                        models.shown(),
                        shown -> {
                            Drawing begun = new Drawing(graph(shown, component, automaton, closed));
                            drawing = begun;
                            return begun.question();
                        });
    }

    /** The picture that {@link #graph} was asked for, as SVG. */
    public String picture(String places) {
        Drawing begun = drawing;
        return begun == null ? "" : begun.svg(places);
    }

    private static Graph graph(LoweredModels models, String name, int automaton, String[] closed)
            throws WrongUse {
        Component component = MainComponent.component(name, models);
        return automaton < 0
                ? ComponentGraph.of(component, DEPTH, new HashSet<>(List.of(closed)))
                : AutomatonGraph.of(component, component.automata().get(automaton));
    }

    private static Run aRun(LoweredModels models, String component, String[] letters, int[] choices)
            throws WrongUse {
        return new Run(
                MainComponent.find(component, models),
                List.of(letters),
                Arrays.stream(choices).boxed().toList());
    }

    private String ask(Asking question) {
        Optional<LoweredModels> lowered = models == null ? Optional.empty() : models.lowered();
        return lowered.map(all -> answer(all, question)).orElse(WITH_ERRORS);
    }

    private static String answer(LoweredModels models, Asking question) {
        try {
            return question.of(models);
        } catch (WrongUse wrong) {
            return ModelAnswers.refusal(String.valueOf(wrong.getMessage()));
        }
    }

    private static Proofs proofs(LoweredModels models, double milliseconds) {
        double end = System.currentTimeMillis() + milliseconds;
        return new Proofs(models, new Budget(() -> System.currentTimeMillis() > end, MOST_STATES));
    }
}
