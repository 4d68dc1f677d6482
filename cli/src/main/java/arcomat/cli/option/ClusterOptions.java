package arcomat.cli.option;

import arcomat.cli.terminal.Console;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineLibrary;
import arcomat.pipeline.campaign.engine.EngineProvider;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.Meeting;
import arcomat.pipeline.file.FileReader;
import arcomat.report.text.Printable;

import picocli.CommandLine.Option;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.function.Consumer;
import java.util.function.Function;

/** Of a campaign and of its workers, which have to say the same. */
public final class ClusterOptions {
    private static final int HIGHEST_PORT = 65_535;

    @Option(
            names = "--cluster",
            paramLabel = "NAME",
            description =
                    "The cluster that makes the runs of a campaign: workers of that name, each"
                            + " started with arcomat campaign-worker.")
    private String cluster;

    @Option(
            names = "--at",
            paramLabel = "HOST[:PORT]",
            defaultValue = "127.0.0.1",
            description =
                    "Where the campaign listens and its workers come: default 127.0.0.1:"
                            + Meeting.PORT
                            + ", for this machine alone.")
    private String address;

    @Option(
            names = "--secret",
            paramLabel = "FILE",
            description =
                    "A file with a secret, the same for campaign and workers: who does not know it"
                            + " cannot take part. Needed where other machines can reach the"
                            + " address.")
    private String secret;

    /** Whether other processes are to make the runs. */
    public boolean isWanted() {
        return cluster != null;
    }

    /**
     * Who starts the engine of a campaign, on the console told who comes and goes.
     *
     * @throws WrongUse where there is no such engine, or nowhere to meet
     */
    public Function<Freight, Engine> engines(PathNames names, Console console) throws WrongUse {
        EngineProvider provider = EngineLibrary.required();
        Meeting meeting = meeting(names);
        return freight -> provider.open(freight, meeting, lines(console.err()));
    }

    /** Lines that come one at a time, while everything else goes on. */
    public static Consumer<String> lines(java.io.PrintWriter out) {
        return line -> {
            out.println(Printable.escape(line));
            out.flush();
        };
    }

    /**
     * @throws WrongUse where the address is none, or anybody could come to it
     */
    public Meeting meeting(PathNames names) throws WrongUse {
        if (cluster == null || cluster.isBlank()) {
            throw new WrongUse("--cluster needs a name that campaign and workers share");
        }
        int colon = address.lastIndexOf(':');
        boolean bare = colon < 0 || address.endsWith("]");
        String host = bare ? address : address.substring(0, colon);
        int port = bare ? Meeting.PORT : port(address.substring(colon + 1));
        String known =
                secret == null
                        ? ""
                        : FileReader.required("secret file", secret, names).text().strip();
        Meeting meeting = new Meeting(cluster, known, host.replaceAll("[\\[\\]]", ""), port);
        if (known.isEmpty() && !isOfThisMachineAlone(meeting)) {
            throw new WrongUse(
                    "--at %s can be reached from other machines: give campaign and workers a file"
                            + " with a secret, by --secret",
                    address);
        }
        return meeting;
    }

    private int port(String text) throws WrongUse {
        if (!text.matches("\\d{1,5}")
                || Integer.parseInt(text) > HIGHEST_PORT
                || text.matches("0+")) {
            throw new WrongUse(
                    "--at %s: '%s' is no port, which is a number from 1 to %d",
                    address, text, HIGHEST_PORT);
        }
        return Integer.parseInt(text);
    }

    private boolean isOfThisMachineAlone(Meeting meeting) throws WrongUse {
        try {
            return InetAddress.getByName(meeting.host()).isLoopbackAddress();
        } catch (UnknownHostException e) {
            throw new WrongUse("--at %s: there is no machine '%s'", address, meeting.host());
        }
    }
}
