package arcomat.pipeline.campaign.engine;

import arcomat.source.Sha256;

/**
 * Where the processes of a cluster meet: the campaign listens there, workers come.
 *
 * @param name of the cluster, as people say it
 * @param secret what nobody else knows; empty if there is none
 * @param host name or address of the campaign's machine
 * @param port from 1 to 65535
 */
public record Meeting(String name, String secret, String host, int port) {
    /** Where nobody says another one. */
    public static final int PORT = 5701;

    /** The place, for people. */
    public String address() {
        return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
    }

    /**
     * What both sides have to say the same. The secret is in it, but cannot be read from it; who
     * listens to the network can still repeat it.
     */
    public String password() {
        return "arcomat-" + Sha256.hex(name + '\0' + secret);
    }
}
