package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.MonaRefinement;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.generate.MonaText;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.explored.ExploredSearches;
import arcomat.semantics.Promise;

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
            Budget budget = limits.budget();
            Certification found = Certification.of(left, right, budget);
            Verdict noted = new NoRun(budget).noted(left, found.verdict());
            file.write(left, right, new Certification(noted, found.certificates()));
            return noted;
        }
    }

    /**
     * The engine, with what it explores in files instead of memory; it goes on with what it finds
     * there. Only the search through configurations is asked.
     *
     * @param models that are asked about; empty before they are known
     */
    record EngineOnDisk(Disk disk, Optional<LoweredModels> models) implements Prover {
        public EngineOnDisk(Disk disk) {
            this(disk, Optional.empty());
        }

        @Override
        public Prover about(LoweredModels asked) {
            return new EngineOnDisk(disk, Optional.of(asked));
        }

        @Override
        public Verdict decide(Promise left, Promise right, AnalysisLimits limits, PathNames names)
                throws WrongUse {
            Budget budget = disk.budget(limits);
            return disk.ofRefinement(
                    left,
                    right,
                    models.orElseThrow(),
                    names,
                    explored -> {
                        try (ExploredSearches searches = explored.alone()) {
                            return ProverOnDisk.refines(left, right, budget, searches);
                        }
                    });
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
