package arcomat.generate.views;

import arcomat.generate.plan.Arrangement;
import arcomat.generate.plan.Draft;
import arcomat.generate.plan.Draft.Stretch;
import arcomat.generate.plan.Program;
import arcomat.generate.plan.Regularity;
import arcomat.generate.text.FileContext;
import arcomat.generate.view.CompositeView.LocalView;
import arcomat.generate.view.CompositeView.LoopsView;
import arcomat.generate.view.CompositeView.PartView;
import arcomat.generate.view.CompositeView.StepView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.model.Component;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** The views of the arrays of parts in one class: what a loop, or a line for one element, does. */
final class ArrayViews {
    private final FileContext context;
    private final Arrangement arrangement;
    private final Draft draft;
    private final List<Composition.Node> nodes;
    private final Copies copies;
    private final List<StepView> fixed = new ArrayList<>();
    private final List<StepView> known = new ArrayList<>();
    private boolean reordered;

    ArrayViews(FileContext context, Arrangement arrangement, Copies copies) {
        this.context = context;
        this.arrangement = arrangement;
        this.draft = arrangement.draft();
        this.nodes = arrangement.composition().nodes();
        this.copies = copies;
    }

    /** The array itself and how it is filled. */
    PartView member(Stretch stretch, Program program) {
        List<PartView.ElementsView> elements = new ArrayList<>();
        for (Regularity.Run run : draft.constructions(stretch)) {
            elements.add(
                    new PartView.ElementsView(
                            arrangement.element(stretch, index(run, stretch)),
                            Arrangement.arguments(nodes.get(run.first()), context, program),
                            variable(run),
                            run.first() - stretch.first(),
                            run.end() - stretch.first()));
        }
        Component component = nodes.get(stretch.first()).component();
        return new PartView(
                context.references().to(context.names().of(component)),
                stretch.field(),
                "",
                stretch.comment(arrangement.composition()),
                stretch.length(),
                elements);
    }

    /** The steps, each after the copies that come right before it. */
    List<StepView> steps(Stretch stretch) {
        List<StepView> steps = new ArrayList<>();
        for (Regularity.Run run : draft.steps(stretch)) {
            int[] late =
                    IntStream.range(0, nodes.get(run.first()).inputs().size())
                            .filter(i -> draft.isLate(stretch, run.first(), i))
                            .toArray();
            reordered |= run.isLoop() && IntStream.of(late).anyMatch(i -> isDelayed(run, i));
            steps.add(view(run, stretch, "step", late));
        }
        return steps;
    }

    private boolean isDelayed(Regularity.Run run, int input) {
        Source source = nodes.get(run.first()).inputs().get(input);
        return source instanceof Source.FromNode from && !from.fresh();
    }

    /** Notes the copies for the start of a slice. */
    void know(Stretch stretch) {
        for (int input = 0; input < nodes.get(stretch.first()).inputs().size(); input++) {
            for (Regularity.Run run : draft.early(stretch, input)) {
                known.add(view(run, stretch, "", input));
            }
        }
    }

    private StepView view(Regularity.Run run, Stretch stretch, String call, int... inputs) {
        LoopLocals locals = new LoopLocals(context, run.isLoop());
        List<AssignmentView> moves = new ArrayList<>();
        List<AssignmentView> flags = new ArrayList<>();
        for (int input : inputs) {
            Copies.Copy copy = copies.toRun(run, input, index(run, stretch), locals);
            moves.addAll(copy.moves());
            flags.addAll(copy.fixed());
        }
        if (!flags.isEmpty()) {
            fixed.add(view(run, stretch, "", flags, locals.receivers()));
        }
        return view(run, stretch, call, moves, moves.isEmpty() ? List.of() : locals.all());
    }

    private StepView view(
            Regularity.Run run,
            Stretch stretch,
            String call,
            List<AssignmentView> moves,
            List<LocalView> locals) {
        String place = arrangement.element(stretch, index(run, stretch));
        return new StepView(
                locals,
                locals.isEmpty() ? place : locals.get(0).name(),
                call,
                moves,
                variable(run),
                run.first() - stretch.first(),
                run.end() - stretch.first());
    }

    private String variable(Regularity.Run run) {
        return run.isLoop() ? context.members().local("i") : "";
    }

    private String index(Regularity.Run run, Stretch stretch) {
        return run.isLoop() ? variable(run) : "" + (run.first() - stretch.first());
    }

    /** What loops do besides the steps of the arrays that have been shown. */
    LoopsView loops() {
        return new LoopsView(fixed, known, reordered);
    }
}
