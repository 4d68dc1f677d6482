package arcomat.cli.command.code;

import arcomat.cli.command.Command;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.LinkJar;
import arcomat.report.brick.BrickReportText;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;

import picocli.CommandLine;
import picocli.CommandLine.Option;

import java.util.Optional;

/** {@code arcomat link}: checks a robot's jar and lets leJOS' linker make a program of it. */
@CommandLine.Command(
        name = "link",
        description = "Links a robot's jar for the brick, with the linker of leJOS NXJ 0.9.1.",
        footer = {
            "  arcomat link --jar build/brick/Fetcher.jar",
            "  arcomat link --jar build/brick/Fetcher.jar --out Fetcher.nxj --nxj-home /opt/lejos",
            "",
            "The jar is checked first: what does not fit on the brick is not linked.",
            "Send the program to the brick with leJOS' own nxjupload.",
            "",
            "Exit status: 0 linked; 1 it does not fit, or the linker failed; 2 wrong use."
        })
public final class LinkCommand extends Command {
    @Option(
            names = "--jar",
            paramLabel = "ROBOT.jar",
            required = true,
            description = "The program, as 'generate --target lejos' makes it.")
    private String jar;

    @Option(
            names = "--out",
            paramLabel = "FILE.nxj",
            description = "The linked program; default: beside the jar.")
    private String out;

    @Option(
            names = "--nxj-home",
            paramLabel = "DIR",
            defaultValue = "${env:NXJ_HOME}",
            description = "The folder of leJOS NXJ; default: the environment's NXJ_HOME.")
    private String nxjHome;

    @Option(
            names = "--limit",
            paramLabel = "SECONDS",
            defaultValue = "60",
            description = "How long the linker may take; default 60.")
    private int limit;

    @Override
    protected int run(Session session) throws WrongUse {
        if (limit < 1) {
            throw new WrongUse("--limit " + limit + " is less than 1");
        }
        Optional<String> home = Optional.ofNullable(nxjHome).filter(text -> !text.isBlank());
        LinkJar.Result result =
                session.run(new LinkJar(jar, Optional.ofNullable(out), home, limit));
        print(FindingsText.render(result.report().findings(), console().style()));
        print(BrickReportText.render(result.report(), console().style()));
        if (result.linked().isPresent()) {
            printLine(success(result.linked().get()));
            return ExitStatus.FINE;
        }
        result.output().forEach(line -> printLine("  " + Printable.escape(line)));
        result.log().ifPresent(log -> printLine("all that the linker said: " + log));
        printLine(
                result.failure()
                        .map(Printable::escape)
                        .orElse("not linked: the jar does not fit on the brick"));
        return ExitStatus.FINDINGS;
    }

    private static String success(LinkJar.Linked linked) {
        String classes =
                linked.classes().isPresent()
                        ? ", " + linked.classes().getAsInt() + " of 256 classes"
                        : "";
        return "linked " + linked.path() + ": " + linked.bytes() + " bytes" + classes;
    }
}
