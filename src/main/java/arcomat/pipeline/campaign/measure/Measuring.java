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
    private final List<MeasuredExpression> expressions;
    private final List<Diagnostic> findings;

    private Measuring(List<MeasuredExpression> expressions, List<Diagnostic> findings) {
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
                MeasureModel.Read read = MeasureModel.read(each, vocabulary);
                findings.addAll(read.findings());
                if (read.findings().isEmpty()) {
                    expressions.add(MeasuredExpression.of(each.fold(), read));
                }
            }
        }
        return new Measuring(expressions, findings);
    }

    /** What is wrong with expressions, at its place in the campaign; then nothing is measured. */
    public List<Diagnostic> findings() {
        return findings;
    }

    /** In one world; any number of runs may be measured at once. */
    public InWorld in(World world) {
        return new InWorld(expressions.stream().map(each -> each.in(world)).toList());
    }

    /** All columns, in a world. */
    public static final class InWorld {
        private final List<MeasuredExpression.InWorld> expressions;

        private InWorld(List<MeasuredExpression.InWorld> expressions) {
            this.expressions = expressions;
        }

        /** Before a run. */
        public Run start() {
            return new Run(expressions);
        }
    }

    /** One run that is measured at each of its steps. */
    public static final class Run implements Onlooker {
        private final List<MeasuredExpression.InWorld> expressions;
        private final List<Fold> folds;

        private Run(List<MeasuredExpression.InWorld> expressions) {
            this.expressions = expressions;
            this.folds = expressions.stream().map(MeasuredExpression.InWorld::start).toList();
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
