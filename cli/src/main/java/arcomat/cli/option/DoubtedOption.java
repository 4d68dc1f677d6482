package arcomat.cli.option;

import arcomat.pipeline.WrongUse;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine.Option;

import java.util.Optional;

/** Of commands that prove, and write down why: what was written down before, and is doubted. */
public final class DoubtedOption {
    @Option(
            names = "--verify-certificate",
            paramLabel = "FILE",
            description = "Search nothing: verify such a file.")
    private String doubted;

    /**
     * The file, where one is to be verified.
     *
     * @param certificate where proofs are to be written
     * @throws WrongUse where both are asked for
     */
    public Optional<String> file(@Nullable String certificate) throws WrongUse {
        if (certificate != null && doubted != null) {
            throw new WrongUse(
                    "--verify-certificate searches nothing, so there is nothing to write for"
                            + " --certificate; leave one of them out");
        }
        return Optional.ofNullable(doubted);
    }
}
