package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.MonaRefinement;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.generate.MonaText;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.explored.ExploredFolder;
import arcomat.pipeline.file.Failures;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;

/** Who decides whether one component refines another. */
public sealed interface Prover {
    /**
     * The decision; unknown where limits do not let it be made.
     *
     * @throws WrongUse where a file or a program cannot be used
     */
    Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names)
            throws WrongUse;

    /** The same for questions about some models. */
    default Prover about(LoweredModels models) {
        return this;
    }

    /** Whether it is asked about all configurations of components with features. */
    default boolean asksMany() {
        return false;
    }

    /** The engine of this tool. */
    record Engine() implements Prover {
        @Override
        public boolean asksMany() {
            return true;
        }

        @Override
        public Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names) {
            return Refinement.check(left, right, limits.budget());
        }
    }

    /**
     * The engine, for one of several questions.
     *
     * @param budget of all of them
     */
    record Within(Budget budget) implements Prover {
        @Override
        public Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names) {
            return Refinement.check(left, right, budget);
        }
    }

    /**
     * The engine, which writes down why it holds, where it does.
     *
     * @param certificate file to write the proof to
     */
    record CertifyingEngine(String certificate) implements Prover {
        @Override
        public Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names)
                throws WrongUse {
            CertificateFile file = new CertificateFile(certificate, names);
            file.requireReplaceable();
            Certification certification = Certification.of(left, right, limits.budget());
            file.write(left, right, certification);
            return certification.verdict();
        }
    }

    /**
     * The engine, with what it explores in files instead of memory; it goes on with what it finds
     * there. Only the search through configurations is asked.
     *
     * @param folder for the files
     * @param version of the tool
     * @param models the files that are asked about
     */
    record EngineOnDisk(String folder, String version, List<SourceFile> models) implements Prover {
        public EngineOnDisk {
            models = List.copyOf(models);
        }

        public EngineOnDisk(String folder, String version) {
            this(folder, version, List.of());
        }

        @Override
        public Prover about(LoweredModels asked) {
            return new EngineOnDisk(folder, version, asked.checked().loaded().sources());
        }

        private static final String GOES_ON =
                "what was explored is kept in '%s': the same command goes on from there";

        @Override
        public Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names)
                throws WrongUse {
            Budget budget = limits.beyondMemory().with(rule -> rule != Shortcut.SYMBOLIC);
            try (ExploredFolder explored =
                    ExploredFolder.open(folder, left, right, models, version, names)) {
                Verdict verdict =
                        Refinement.check(
                                left,
                                right,
                                budget,
                                one -> Optional.of(explored.stores(one, budget)));
                return verdict.answer() == Answer.UNKNOWN && explored.isUsed()
                        ? verdict.with(GOES_ON.formatted(folder))
                        : verdict;
            } catch (UncheckedIOException failed) {
                throw ExploredFolder.failure(folder, failed);
            } catch (IOException unclosed) {
                throw Failures.cannot("write to", folder, unclosed);
            }
        }
    }

    /**
     * Searches nothing, and verifies a proof.
     *
     * @param certificate file with the proof
     */
    record Verifier(String certificate) implements Prover {
        @Override
        public Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names)
                throws WrongUse {
            return new CertificateFile(certificate, names).verify(left, right, limits.budget());
        }
    }

    /**
     * The program MONA: another engine, which knows nothing of this one.
     *
     * @param program its name or path
     */
    record Mona(String program) implements Prover {
        /** In seconds; nobody waits longer for an answer, unless he says so. */
        private static final int PATIENCE = 60;

        @Override
        public Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names)
                throws WrongUse {
            Budget budget = limits.budget();
            MonaRefinement refinement = MonaRefinement.of(left, right, budget);
            if (refinement.settled().isPresent()) {
                return refinement.settled().get();
            }
            String text = MonaText.render(refinement.formula());
            String spent = budget.exhausted(0);
            if (spent != null) {
                return refinement.unknown(spent);
            }
            MonaAnswer answer =
                    MonaProgram.find(program, names)
                            .decide(text, limits.secondsLeft().orElse(PATIENCE));
            if (answer instanceof MonaAnswer.Counterexample counterexample) {
                return refinement.fails(counterexample.rows());
            }
            return answer instanceof MonaAnswer.None none
                    ? refinement.unknown(none.reason())
                    : refinement.holds();
        }
    }
}
