package arcomat.pipeline;

import arcomat.brick.BrickReport;
import arcomat.check.law.Profile;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.AnalysisResult;
import arcomat.pipeline.analysis.AnalyzeRequest;
import arcomat.pipeline.analysis.AnalyzeResult;
import arcomat.pipeline.analysis.AnalyzeStep;
import arcomat.pipeline.analysis.ContradictionsRequest;
import arcomat.pipeline.analysis.ContradictionsResult;
import arcomat.pipeline.analysis.ContradictionsStep;
import arcomat.pipeline.analysis.DiffResult;
import arcomat.pipeline.analysis.DiffStep;
import arcomat.pipeline.analysis.EvolutionResult;
import arcomat.pipeline.analysis.EvolutionStep;
import arcomat.pipeline.analysis.MonaResult;
import arcomat.pipeline.analysis.MonaStep;
import arcomat.pipeline.analysis.RefinesRequest;
import arcomat.pipeline.analysis.RefinesStep;
import arcomat.pipeline.analysis.TransitionTestsRequest;
import arcomat.pipeline.analysis.TransitionTestsResult;
import arcomat.pipeline.analysis.TransitionTestsStep;
import arcomat.pipeline.analysis.VerifyStep;
import arcomat.pipeline.brick.BrickRunRequest;
import arcomat.pipeline.brick.BrickRunResult;
import arcomat.pipeline.brick.BrickRunStep;
import arcomat.pipeline.brick.JarReader;
import arcomat.pipeline.brick.LinkRequest;
import arcomat.pipeline.brick.LinkResult;
import arcomat.pipeline.brick.LinkStep;
import arcomat.pipeline.check.BaselineFile;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.diagram.DiagramRequest;
import arcomat.pipeline.diagram.DiagramResult;
import arcomat.pipeline.diagram.DiagramStep;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.ReportPage;
import arcomat.pipeline.format.FormatResult;
import arcomat.pipeline.format.FormatStep;
import arcomat.pipeline.gate.GateRequest;
import arcomat.pipeline.gate.GateResult;
import arcomat.pipeline.gate.GateStep;
import arcomat.pipeline.generate.GenerateStep;
import arcomat.pipeline.generate.GenerationRequest;
import arcomat.pipeline.generate.GenerationResult;
import arcomat.pipeline.monitor.MonitorRequest;
import arcomat.pipeline.monitor.MonitorResult;
import arcomat.pipeline.monitor.MonitorStep;
import arcomat.pipeline.recheck.IncrementalCheck;
import arcomat.pipeline.recheck.Recheck;
import arcomat.pipeline.recheck.StateFile;
import arcomat.pipeline.simulate.Audience;
import arcomat.pipeline.simulate.Dialogue;
import arcomat.pipeline.simulate.SimulateStep;
import arcomat.pipeline.simulate.SimulationRequest;
import arcomat.pipeline.simulate.SimulationResult;
import arcomat.pipeline.simulate.TestResult;
import arcomat.pipeline.simulate.TestStep;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.pipeline.world.WorldStep;
import arcomat.report.finding.Baseline;
import arcomat.report.page.Page;
import arcomat.report.page.PageText;
import arcomat.source.Diagnostic;
import arcomat.world.Recording;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** Everything that the tool does, for whoever asks: the command line, a build, a test. */
public final class Pipeline {
    private final PathNames names;
    private final Progress progress;

    /**
     * @param directory the folder that relative paths start from
     */
    public Pipeline(Path directory, Progress progress) {
        this.names = new PathNames(directory.toAbsolutePath().normalize());
        this.progress = progress;
    }

    /**
     * Writes a text to a file, at once or not at all; folders on the way are made.
     *
     * @param file as the user wrote it
     * @throws WrongUse where it cannot be written
     */
    public void writeFile(String file, String text) throws WrongUse {
        AtomicFile.write(file, text.getBytes(StandardCharsets.UTF_8), names);
    }

    /**
     * Finds out whether a report can be written, before anything is done.
     *
     * @param folder as the user wrote it
     * @throws WrongUse where it cannot
     */
    public void requireReportFolder(String folder) throws WrongUse {
        new ReportPage(folder, names).requireWritable();
    }

    /**
     * Writes a page into a folder, at once or not at all.
     *
     * @param folder as the user wrote it; it is made if need be
     * @throws WrongUse where it cannot be written
     */
    public void writeReport(String folder, Page page) throws WrongUse {
        progress.step("writing " + folder + "/" + ReportPage.NAME);
        new ReportPage(folder, names).write(PageText.render(page));
    }

    /**
     * Checks files and folders.
     *
     * @param executable also asks for what a model needs in order to run
     */
    public CheckResult check(List<String> paths, boolean executable) {
        Profile profile = executable ? Profile.EXECUTABLE : Profile.REQUIREMENTS;
        return CheckedModels.check(paths, profile, names, progress).result();
    }

    /**
     * Checks files and folders as {@link #check} does, but only what has changed since the last
     * time and what that touches. The result is the same.
     *
     * @param state a file in which the check leaves for the next one what it needs to know
     * @param tool whatever tells this tool from others that may find something else
     * @throws WrongUse where the state cannot be written
     */
    public Recheck checkAgain(List<String> paths, boolean executable, String state, String tool)
            throws WrongUse {
        Profile profile = executable ? Profile.EXECUTABLE : Profile.REQUIREMENTS;
        IncrementalCheck.Outcome outcome =
                new IncrementalCheck(paths, profile, tool, names, progress)
                        .run(new StateFile(state, names));
        writeFile(state, StateFile.text(outcome.state()));
        return new Recheck(outcome.result(), outcome.checked());
    }

    /**
     * Tells findings that are new from those that a baseline knows.
     *
     * @param file the baseline, as the user wrote it
     * @throws WrongUse where it cannot be read
     */
    public Baseline.Comparison compareWithBaseline(CheckResult check, String file) throws WrongUse {
        return new BaselineFile(file, names).compare(check);
    }

    /**
     * Writes a baseline that knows all findings.
     *
     * @throws WrongUse where it cannot be written
     */
    public void writeBaseline(List<Diagnostic> findings, String file) throws WrongUse {
        writeFile(file, new BaselineFile(file, names).text(findings));
    }

    /**
     * Brings files into canonical form.
     *
     * @param write false only lists what would change
     */
    public FormatResult format(List<String> paths, boolean write) {
        return FormatStep.run(paths, write, names, progress);
    }

    /**
     * Runs a component.
     *
     * @param dialogue asked and told while the model runs
     * @throws WrongUse where the request does not fit the models
     */
    public SimulationResult simulate(
            SimulationRequest request, List<String> paths, Dialogue dialogue) throws WrongUse {
        return SimulateStep.run(request, paths, dialogue, names, progress);
    }

    /**
     * Runs a component before an audience. The result holds no steps, unless somebody else needs
     * them: they would fill the memory.
     *
     * @param dialogue asked and told while the model runs
     * @throws WrongUse where the request does not fit the models
     */
    public SimulationResult simulate(
            SimulationRequest request, List<String> paths, Dialogue dialogue, Audience audience)
            throws WrongUse {
        return SimulateStep.run(request, paths, dialogue, audience, names, progress);
    }

    /**
     * Runs the stream tests in files and folders.
     *
     * @throws WrongUse where there are none
     */
    public TestResult test(List<String> paths) throws WrongUse {
        return TestStep.run(paths, names, progress);
    }

    /**
     * Writes code.
     *
     * @throws WrongUse where the request does not fit the models, or the folder cannot be written
     */
    public GenerationResult generate(GenerationRequest request, List<String> paths)
            throws WrongUse {
        return GenerateStep.run(request, paths, names, progress);
    }

    /**
     * Checks a robot's jar against what the brick has.
     *
     * @throws WrongUse where there is no such jar
     */
    public BrickReport checkBrick(String jar) throws WrongUse {
        return JarReader.read(jar, names).report();
    }

    /**
     * Runs a robot's jar on a simulated brick.
     *
     * @throws WrongUse where jar or script cannot be read
     * @throws arcomat.sim.time.OutOfPatience where it takes longer than the request allows
     */
    public BrickRunResult runBrick(BrickRunRequest request) throws WrongUse {
        return BrickRunStep.run(request, names, progress);
    }

    /**
     * Brings the programs of a world's robots.
     *
     * @param file the world, as the user wrote it
     * @param runDevices whether Java files that the world names as devices may be run, which is a
     *     finding otherwise
     * @throws WrongUse where it cannot be read
     */
    public PreparedWorld prepareWorld(String file, boolean runDevices) throws WrongUse {
        return WorldStep.prepare(file, runDevices, names, progress);
    }

    /**
     * Writes a page that plays a run of a world again, and the recording that it plays.
     *
     * @throws WrongUse where the folder is somebody else's, or cannot be written
     */
    public void writeReplay(Recording recording, String title, String folder) throws WrongUse {
        WorldStep.write(recording, title, folder, names);
    }

    /**
     * Checks a robot's jar and links it for the brick.
     *
     * @throws WrongUse where there is no such jar or no linker
     */
    public LinkResult link(LinkRequest request) throws WrongUse {
        return LinkStep.run(request, names, progress);
    }

    /**
     * Examines automata one by one.
     *
     * @throws WrongUse where there are none, or the request does not fit the models
     */
    public AnalyzeResult analyze(AnalyzeRequest request, List<String> paths) throws WrongUse {
        return AnalyzeStep.run(request, paths, names, progress);
    }

    /**
     * Draws components, automata and class diagrams.
     *
     * @throws WrongUse where there are none, or the folder cannot be written
     */
    public DiagramResult diagram(DiagramRequest request, List<String> paths) throws WrongUse {
        return DiagramStep.run(request, paths, names, progress);
    }

    /**
     * Compares two components.
     *
     * @throws WrongUse where the request does not fit the models
     */
    public AnalysisResult refines(RefinesRequest request, List<String> paths) throws WrongUse {
        return RefinesStep.run(request, paths, names, progress);
    }

    /**
     * Writes the question whether one component refines another as a text for the program MONA.
     *
     * @param out the file to be written
     * @throws WrongUse where the request does not fit the models, or the file cannot be written
     */
    public MonaResult mona(RefinesRequest request, String out, List<String> paths) throws WrongUse {
        return MonaStep.run(request, out, paths, names, progress);
    }

    /**
     * Writes stream tests that take every transition.
     *
     * @throws WrongUse where the request does not fit the models, or the folder cannot be written
     */
    public TransitionTestsResult transitionTests(TransitionTestsRequest request, List<String> paths)
            throws WrongUse {
        return TransitionTestsStep.run(request, paths, names, progress);
    }

    /**
     * Looks for contradictions between the requirements on a component.
     *
     * @throws WrongUse where the request does not fit the models, or the folder cannot be written
     */
    public ContradictionsResult contradictions(ContradictionsRequest request, List<String> paths)
            throws WrongUse {
        return ContradictionsStep.run(request, paths, names, progress);
    }

    /** Shows that models keep all promises that they say they keep. */
    public AnalysisResult verify(List<String> paths, AnalysisLimits limits) {
        return VerifyStep.run(paths, limits, names, progress);
    }

    /**
     * Writes classes that watch a component.
     *
     * @throws WrongUse where the request does not fit the models, or the folder cannot be written
     */
    public MonitorResult monitor(MonitorRequest request, List<String> paths) throws WrongUse {
        return MonitorStep.run(request, paths, names, progress);
    }

    /**
     * Compares two components in both directions.
     *
     * @throws WrongUse where the request does not fit the models
     */
    public DiffResult diff(RefinesRequest request, List<String> paths) throws WrongUse {
        return DiffStep.run(request, paths, names, progress);
    }

    /**
     * Compares versions of a component, the oldest first, with all earlier ones.
     *
     * @throws WrongUse where one does not exist
     */
    public EvolutionResult evolution(
            List<String> versions, List<String> paths, AnalysisLimits limits) throws WrongUse {
        return EvolutionStep.run(versions, paths, limits, names, progress);
    }

    /**
     * Compares every component with what it was in another model root.
     *
     * @throws WrongUse where the base is a part of the new models
     */
    public GateResult gate(GateRequest request) throws WrongUse {
        return GateStep.run(request, names, progress);
    }
}
