package arcomat.cli.command.proof;

import arcomat.analysis.refinement.Answered;
import arcomat.cli.command.ComparisonCommand;
import arcomat.cli.option.DiskOption;
import arcomat.cli.option.DoubtedOption;
import arcomat.cli.option.PageOption;
import arcomat.cli.option.StrictOption;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.Disk;
import arcomat.pipeline.analysis.ProveRefinement;
import arcomat.pipeline.analysis.Prover;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;
import arcomat.report.verdict.ObligationsText;
import arcomat.report.verdict.VerdictJson;
import arcomat.report.verdict.VerdictPage;
import arcomat.report.verdict.VerdictText;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

import java.util.List;
import java.util.Optional;

/** {@code arcomat refines}: whether one component keeps the promises of another. */
@CommandLine.Command(
        name = "refines",
        description = "Proves that one component keeps what another promises, or how not.",
        footer = {
            "  arcomat refines coffee.fig5.AvoidCrash coffee.fig3.AvoidCrash models/coffee",
            "  arcomat refines p.Dimmer p.Lamp models    with features: in all configurations",
            "  arcomat refines --completion ignore,ignore p.New p.Old models",
            "  arcomat refines p.Robot 'p.Robot#waits' models    one automaton of several",
            "  arcomat refines --diagram failure.svg p.New p.Old models    draws a counterexample",
            "  arcomat refines --engine mona p.New p.Old models    a second opinion",
            "  arcomat refines --map p.Adapter p.Wheels p.Drive models    with other ports",
            "  arcomat refines --report build/refines p.New p.Old models    to look at",
            "",
            "Exit status: 0 holds; 1 fails; 3 unknown; 2 wrong use or models with errors."
        })
public final class RefinesCommand extends ComparisonCommand<List<Answered>> {
    enum Engine {
        arcomat,
        mona
    }

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            defaultValue = "arcomat",
            description = "Who decides: ${COMPLETION-CANDIDATES}; default arcomat.")
    private Engine engine;

    @Option(
            names = "--mona",
            paramLabel = "PROGRAM",
            description = "The program for '--engine mona'; default: mona, where programs are.")
    private String mona;

    @Option(
            names = "--certificate",
            paramLabel = "FILE",
            description = "Where it holds, write down why: pairs, or clauses.")
    private String certificate;

    @Mixin private DoubtedOption doubted = new DoubtedOption();

    @Mixin private DiskOption onDisk = new DiskOption();

    @Option(
            names = "--diagram",
            paramLabel = "FILE",
            description = "Where it fails, draw how: an .svg or .png file.")
    private String diagram;

    @Option(
            names = "--map",
            paramLabel = "COMPONENT",
            description = {
                "Where A and B have different ports: how those of A stand for those of B, by its",
                "components Inputs and Outputs."
            })
    private String map;

    @Mixin private StrictOption strict = new StrictOption();

    @Mixin private PageOption report = new PageOption();

    @Override
    protected Task<CheckedAnswer<List<Answered>>> task(Session session) throws WrongUse {
        Optional<String> proof = doubted.file(certificate);
        boolean plain = engine == Engine.arcomat && certificate == null && proof.isEmpty();
        Optional<Disk> disk = onDisk.disk();
        if (disk.isPresent() && (!plain || map != null)) {
            throw new WrongUse(
                    "--disk is for the search of this tool, without maps and certificates; leave"
                            + " one of them out");
        }
        if (map != null && !plain) {
            throw new WrongUse(
                    "--map asks the engine of this tool, and has no certificates yet; leave one of"
                            + " them out");
        }
        report.prepare(session);
        Prover prover = prover(proof, disk);
        return new ProveRefinement(
                sides(),
                prover,
                Optional.ofNullable(map),
                Optional.ofNullable(diagram),
                paths(),
                limits());
    }

    private Prover prover(Optional<String> proof, Optional<Disk> disk) throws WrongUse {
        if (mona != null && engine != Engine.mona) {
            throw new WrongUse("--mona names a program, and only '--engine mona' asks it");
        }
        if (engine == Engine.mona) {
            if (certificate != null || proof.isPresent()) {
                throw new WrongUse("MONA knows no certificates; leave '--engine mona' out");
            }
            return new Prover.Mona(mona == null ? "mona" : mona);
        }
        if (proof.isPresent()) {
            return new Prover.Verifier(proof.get());
        }
        if (disk.isPresent()) {
            return new Prover.EngineOnDisk(disk.get());
        }
        return certificate == null ? new Prover.Engine() : new Prover.CertifyingEngine(certificate);
    }

    @Override
    protected void report(List<Answered> answers, Session session) throws WrongUse {
        report.write(
                () ->
                        answers.size() == 1
                                ? VerdictPage.of("refines", answers.get(0), limitsInWords())
                                : VerdictPage.of("refines", title(), answers, limitsInWords()),
                session);
    }

    @Override
    protected String json(List<Answered> answers) {
        return VerdictJson.ofRefines(answers);
    }

    @Override
    protected String text(List<Answered> answers, Style style) {
        boolean drawn =
                diagram != null
                        && answers.stream().anyMatch(each -> !each.verdict().trace().isEmpty());
        String text =
                answers.size() == 1
                        ? VerdictText.render(answers.get(0), style)
                        : ObligationsText.all(answers, style);
        return text + (drawn ? "drawn in " + diagram + "\n" : "");
    }

    @Override
    protected int status(List<Answered> answers) {
        return status(strict.of(answers));
    }
}
