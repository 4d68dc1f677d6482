package arcomat.pipeline.campaign.measure;

import arcomat.campaign.Campaign;
import arcomat.campaign.Measure;
import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Scene;
import arcomat.world.World;

import java.util.ArrayList;
import java.util.List;

/** The columns that a campaign defines, ready to be measured in any of its worlds. */
public final class Measuring {
    private final List<Measure.Fold> folds;
    private final List<MeasuredExpression> expressions;
    private final List<Diagnostic> findings;

    private Measuring(
            List<Measure.Fold> folds,
            List<MeasuredExpression> expressions,
            List<Diagnostic> findings) {
        this.folds = List.copyOf(folds);
        this.expressions = List.copyOf(expressions);
        this.findings = List.copyOf(findings);
    }

    /**
     * @param world text of the world, with its parameters
     */
    public static Measuring of(Campaign campaign, SourceFile world) {
        List<MeasuredExpression> expressions = new ArrayList<>();
        List<Diagnostic> findings = new ArrayList<>();
        if (!campaign.measures().isEmpty()) {
            Vocabulary vocabulary = Vocabulary.of(campaign, world);
            for (Measure each : campaign.measures()) {
                String type =
                        each.fold().isOfNumber() ? MeasureModel.NUMBER : MeasureModel.CONDITION;
                MeasuredExpression.Reading read =
                        MeasuredExpression.read(each.expression(), type, vocabulary);
                findings.addAll(read.findings());
                read.expression().ifPresent(expressions::add);
            }
        }
        List<Measure.Fold> folds = campaign.measures().stream().map(Measure::fold).toList();
        return new Measuring(folds, expressions, findings);
    }

    /** What is wrong with expressions, at its place in the campaign; then nothing is measured. */
    public List<Diagnostic> findings() {
        return findings;
    }

    /** In one world; any number of runs may be measured at once. */
    public InWorld in(World world) {
        return new InWorld(folds, expressions.stream().map(each -> each.in(world)).toList());
    }

    /** All columns, in a world. */
    public static final class InWorld {
        private final List<Measure.Fold> folds;
        private final List<MeasuredExpression.InWorld> expressions;

        private InWorld(List<Measure.Fold> folds, List<MeasuredExpression.InWorld> expressions) {
            this.folds = folds;
            this.expressions = expressions;
        }

        /** Before a run. */
        public Run start() {
            return new Run(folds, expressions);
        }
    }

    /** One run that is measured at each of its steps. */
    public static final class Run implements Onlooker {
        private final List<MeasuredExpression.InWorld> expressions;
        private final List<Fold> folds;

        private Run(List<Measure.Fold> ways, List<MeasuredExpression.InWorld> expressions) {
            this.expressions = expressions;
            this.folds = ways.stream().map(Fold::of).toList();
        }

        @Override
        public void see(Scene scene, Instruments instruments) {
            for (int i = 0; i < folds.size(); i++) {
                folds.get(i).see(scene, expressions.get(i).read(scene, instruments));
            }
        }

        /** One for each column, in the order of the campaign; not a number where there is none. */
        public List<Double> answers() {
            return folds.stream().map(Fold::answer).toList();
        }
    }
}
