package arcomat.cli.option;

import arcomat.cli.terminal.Version;
import arcomat.pipeline.analysis.Disk;

import picocli.CommandLine.Option;

import java.util.Optional;

/** Of commands that search for long: a folder for what is explored. */
public final class DiskOption {
    @Option(
            names = "--disk",
            paramLabel = "FOLDER",
            description = {
                "Keep what is explored in files there, not in memory; the same command goes on"
                        + " where",
                "it was ended."
            })
    private String folder;

    /** The folder, where one is named. */
    public Optional<Disk> disk() {
        return Optional.ofNullable(folder).map(each -> new Disk(each, Version.identity()));
    }
}
