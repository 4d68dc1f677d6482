package arcomat.generate;

import arcomat.generate.view.AssignmentView;
import arcomat.generate.view.PartView;
import arcomat.generate.view.StepView;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** The views of the arrays of parts in one class: what a loop, or a line for one element, does. */
final class ArrayContent {
    private final FileContext context;
    private final Arrangement arrangement;
    private final Copies copies;
    private final List<StepView> fixed = new ArrayList<>();
    private final List<StepView> known = new ArrayList<>();
    private boolean reordered;

    ArrayContent(FileContext context, Arrangement arrangement, Copies copies) {
        this.context = context;
        this.arrangement = arrangement;
        this.copies = copies;
    }

    /** The array itself and how it is filled. */
    PartView member(Stretch stretch, Program program) {
        Composition.Node first = arrangement.composition().nodes().get(stretch.first());
        List<PartView.ElementsView> elements = new ArrayList<>();
        for (Regularity.Run run : arrangement.draft().constructions(stretch)) {
            Composition.Node node = arrangement.composition().nodes().get(run.first());
            elements.add(
                    new PartView.ElementsView(
                            arrangement.element(stretch, index(run, stretch)),
                            Arrangement.arguments(node, context, program),
                            variable(run),
                            run.first() - stretch.first(),
                            run.end() - stretch.first()));
        }
        return new PartView(
                context.references().to(context.names().of(first.component())),
                stretch.field(),
                "",
                stretch.comment(arrangement.composition()),
                stretch.length(),
                elements);
    }

    /** The steps, each after the copies that come right before it. */
    List<StepView> steps(Stretch stretch) {
        List<StepView> steps = new ArrayList<>();
        for (Regularity.Run run : arrangement.draft().steps(stretch)) {
            int[] late =
                    inputs(run)
                            .filter(i -> arrangement.draft().isLate(stretch, run.first(), i))
                            .toArray();
            reordered |= run.isLoop() && IntStream.of(late).anyMatch(i -> isDelayed(run, i));
            steps.add(view(run, stretch, "step", late));
        }
        return steps;
    }

    private boolean isDelayed(Regularity.Run run, int input) {
        Source source = arrangement.composition().nodes().get(run.first()).inputs().get(input);
        return source instanceof Source.FromNode from && !from.fresh();
    }

    /** Notes the copies for the start of a slice. */
    void know(Stretch stretch) {
        int inputs = arrangement.composition().nodes().get(stretch.first()).inputs().size();
        for (int input = 0; input < inputs; input++) {
            for (Regularity.Run run : arrangement.draft().early(stretch, input)) {
                known.add(view(run, stretch, "", input));
            }
        }
    }

    private StepView view(Regularity.Run run, Stretch stretch, String call, int... inputs) {
        List<AssignmentView> moves = new ArrayList<>();
        List<AssignmentView> flags = new ArrayList<>();
        for (int input : inputs) {
            copies.toRun(run, input, index(run, stretch), moves, flags);
        }
        if (!flags.isEmpty()) {
            fixed.add(view(run, stretch, "", flags));
        }
        return view(run, stretch, call, moves);
    }

    private StepView view(
            Regularity.Run run, Stretch stretch, String call, List<AssignmentView> moves) {
        return new StepView(
                arrangement.element(stretch, index(run, stretch)),
                call,
                moves,
                variable(run),
                run.first() - stretch.first(),
                run.end() - stretch.first());
    }

    private IntStream inputs(Regularity.Run run) {
        return IntStream.range(
                0, arrangement.composition().nodes().get(run.first()).inputs().size());
    }

    private String variable(Regularity.Run run) {
        return run.isLoop() ? context.members().local("i", "") : "";
    }

    private String index(Regularity.Run run, Stretch stretch) {
        return run.isLoop() ? variable(run) : "" + (run.first() - stretch.first());
    }

    /** Whether there is something in a loop that only the order of the steps explains. */
    boolean reordered() {
        return reordered;
    }

    List<StepView> fixed() {
        return fixed;
    }

    List<StepView> known() {
        return known;
    }
}
