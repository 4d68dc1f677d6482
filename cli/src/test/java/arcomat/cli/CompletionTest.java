package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import arcomat.cli.Shell.Outcome;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** What the distribution brings for shells and for the program man, tried by these. */
@Tag("distribution")
class CompletionTest {
    private static final Path SHARE = Path.of("build/install/arcomat/share").toAbsolutePath();

    @TempDir private Path temporary;

    private Outcome bash(String line) throws Exception {
        return new Shell(temporary).run(line);
    }

    private boolean isThere(String program) throws Exception {
        return bash("command -v " + program).status() == 0;
    }

    /**
     * Bash is asked as it asks: words, the number of the last one, the function that is registered.
     */
    @ParameterizedTest
    @CsvSource({
        "'ver', verify",
        "'check --str', --strict",
        "'check --profile ex', executable",
        "'new --kind co', component",
        "'completion f', fish"
    })
    void bashCompletes(String typed, String completed) throws Exception {
        Path script = SHARE.resolve("bash-completion/completions/arcomat");
        Outcome asked =
                bash(
                        """
                        source %s
                        registered=$(complete -p arcomat) || exit 9
                        [[ $registered =~ -F\\ ([^ ]+) ]] || exit 8
                        COMP_WORDS=(arcomat %s)
                        COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
                        COMP_LINE='arcomat %s'
                        COMP_POINT=${#COMP_LINE}
                        ${BASH_REMATCH[1]} arcomat "${COMP_WORDS[COMP_CWORD]}"
                        printf '%%s\\n' "${COMPREPLY[@]}"
                        """
                                .formatted(script, typed, typed));
        // Bash itself lets nobody else set options of a completion; that is all it may complain
        // about.
        assertThat(asked.err().lines()).allMatch(line -> line.contains("compopt: not currently"));
        assertThat(asked.out().lines()).contains(completed);
        assertThat(asked.status()).isZero();
    }

    @Test
    void theCommandPrintsWhatTheDistributionHas() throws Exception {
        assertThat(bash("$A completion bash").out())
                .isEqualTo(Files.readString(SHARE.resolve("bash-completion/completions/arcomat")));
        assertThat(bash("$A completion fish").out())
                .isEqualTo(
                        Files.readString(SHARE.resolve("fish/vendor_completions.d/arcomat.fish")));
    }

    @Test
    void zshCompletesWhereItIsInstalled() throws Exception {
        assumeTrue(isThere("zsh"), "zsh is not installed");
        Outcome asked =
                bash(
                        "zsh -fc 'autoload -Uz compinit && compinit -u -d zcompdump && source "
                                + SHARE.resolve("zsh/arcomat.zsh")
                                + " && print $_comps[arcomat]'");
        assertThat(asked.err()).isEmpty();
        assertThat(asked.out()).contains("_bash_complete");
    }

    @Test
    void fishCompletesWhereItIsInstalled() throws Exception {
        assumeTrue(isThere("fish"), "fish is not installed");
        Path script = SHARE.resolve("fish/vendor_completions.d/arcomat.fish");
        Outcome asked =
                bash(
                        "fish --no-config -c 'source "
                                + script
                                + "; complete -C \"arcomat check --str\"; complete -C \"arcomat"
                                + " ver\"'");
        assertThat(asked.err()).isEmpty();
        assertThat(asked.out()).contains("--strict", "verify");
    }

    @Test
    void everyCommandHasAPageThatManCanShowWhereGroffIsInstalled() throws Exception {
        Path pages = SHARE.resolve("man/man1");
        List<Path> files;
        try (Stream<Path> all = Files.list(pages)) {
            files = all.sorted().toList();
        }
        assertThat(files)
                .extracting(page -> page.getFileName().toString())
                .contains("arcomat.1", "arcomat-check.1", "arcomat-watch.1");
        assumeTrue(isThere("groff"), "groff is not installed");
        for (Path page : files) {
            Outcome shown = bash("groff -man -ww -Tascii -P-cbou " + page);
            assertThat(shown.err()).as(page.toString()).isEmpty();
            assertThat(shown.out()).contains("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS");
        }
        String check = bash("groff -man -Tascii -P-cbou " + pages.resolve("arcomat-check.1")).out();
        assertThat(check)
                .contains("--strict")
                .contains("Treat warnings as errors.")
                .contains("arcomat check --strict --format json . > findings.json");
    }
}
