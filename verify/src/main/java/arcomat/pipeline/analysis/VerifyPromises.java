package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Obligations;
import arcomat.analysis.refinement.Obligations.Obligation;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.semantics.Promise;
import arcomat.semantics.value.TooManyWays;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Shows everything that has to be shown of the models that were named.
 *
 * @param certificate file to write the proofs of what holds to
 * @param doubted file with proofs; then nothing is searched, and these are verified
 * @param disk where what is explored is kept, if not in memory
 */
public record VerifyPromises(
        List<String> paths,
        Optional<String> certificate,
        Optional<String> doubted,
        Optional<Disk> disk,
        AnalysisLimits limits)
        implements ModelQuestion<List<Answered>> {
    public VerifyPromises(List<String> paths, AnalysisLimits limits) {
        this(paths, Optional.empty(), Optional.empty(), Optional.empty(), limits);
    }

    @Override
    public Asked asked() {
        return Asked.WHAT_IS_WHOLE;
    }

    @Override
    public List<Answered> answer(LoweredModels models, Session session) throws WrongUse {
        if (doubted.isPresent()) {
            PromiseProver verifier = new CertificateFile(doubted.get(), session.names()).verifier();
            return answers(models, verifier, limits.budget(), session.progress());
        }
        if (disk.isPresent()) {
            return onDisk(disk.get(), models, session);
        }
        return certificate.isPresent()
                ? certified(
                        new CertificateFile(certificate.get(), session.names()), models, session)
                : answers(models, limits.budget(), session.progress());
    }

    private List<Answered> onDisk(Disk kept, LoweredModels models, Session session)
            throws WrongUse {
        Budget budget = kept.budget(limits);
        return kept.ofPromises(
                models,
                session.names(),
                explored ->
                        answers(models, new ProverOnDisk(explored), budget, session.progress()));
    }

    private List<Answered> certified(CertificateFile file, LoweredModels models, Session session)
            throws WrongUse {
        file.requireReplaceable();
        Budget budget = limits.budget();
        NoRun noRun = new NoRun(budget);
        CertifyingProver prover = new CertifyingProver(noRun);
        List<Answered> answers = answers(models, prover, noRun, budget, session.progress());
        file.write(prover.proofs());
        return answers;
    }

    /** The same of models that somebody else has read, with limits of his own. */
    public static List<Answered> answers(LoweredModels models, Budget budget, Progress progress) {
        return answers(models, PromiseProver.ENGINE, budget, progress);
    }

    private static List<Answered> answers(
            LoweredModels models, PromiseProver prover, Budget budget, Progress progress) {
        return answers(models, prover, new NoRun(budget), budget, progress);
    }

    private static List<Answered> answers(
            LoweredModels models,
            PromiseProver prover,
            NoRun noRun,
            Budget budget,
            Progress progress) {
        InstanceArguments instances = InstanceArguments.in(models.model());
        Obligations.All all = Obligations.of(models.model(), models.named(), instances::of);
        List<Answered> answers = new ArrayList<>();
        for (Obligation obligation : all.obligations()) {
            String left = obligation.left().title();
            String right = obligation.right().title();
            progress.step("comparing " + left + " with " + right);
            Promise side = obligation.left();
            Verdict verdict = noRun.noted(side, prover.refines(side, obligation.right(), budget));
            List<Promise> sides = List.of(obligation.left(), obligation.right());
            answers.add(new Answered(left, right, obligation.place(), verdict, sides));
        }
        all.open()
                .forEach(
                        name ->
                                answers.add(
                                        takesArguments(
                                                models.model().component(name).orElseThrow())));
        all.onlyRun()
                .forEach(
                        name -> answers.add(onlyRun(models.model().component(name).orElseThrow())));
        answers.addAll(
                new InvariantAnswers(models, prover, noRun, budget, progress).all(instances));
        return answers;
    }

    private static Answered onlyRun(Component component) {
        String reason = component.qualifiedName() + " has " + TooManyWays.REASON;
        return new Answered(
                component.qualifiedName(), "", component.span(), Verdict.unknown(reason));
    }

    private static Answered takesArguments(Component component) {
        String name = component.qualifiedName();
        String reason =
                name
                        + " takes arguments, and no part gives it some; ask with some: arcomat"
                        + " refines '"
                        + name
                        + "(..)' B PATH";
        return new Answered(name, "", component.span(), Verdict.unknown(reason));
    }
}
