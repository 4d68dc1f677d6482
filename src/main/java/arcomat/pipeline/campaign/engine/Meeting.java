package arcomat.pipeline.campaign.engine;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

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
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            digest.update(name.getBytes(StandardCharsets.UTF_8));
            digest.update((byte) 0);
            digest.update(secret.getBytes(StandardCharsets.UTF_8));
            return "arcomat-" + HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java has SHA-256", e);
        }
    }
}
