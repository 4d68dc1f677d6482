package arcomat.cluster.hazelcast;

import arcomat.pipeline.campaign.engine.Meeting;

import com.hazelcast.client.config.ClientConfig;
import com.hazelcast.client.config.ClientConnectionStrategyConfig.ReconnectMode;
import com.hazelcast.client.impl.connection.tcp.RoutingMode;
import com.hazelcast.config.ClassFilter;
import com.hazelcast.config.Config;
import com.hazelcast.config.JavaSerializationFilterConfig;
import com.hazelcast.config.NetworkConfig;

import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * Hazelcast, with nothing but what is needed: no search for others, no report to its makers, no
 * objects of Java's, no log. Nothing of it is read from files or the environment.
 */
final class Settings {
    /** After so long without a sign of life, the other side counts as dead. */
    private static final int SILENCE_SECONDS = 20;

    /** Held, because Java forgets what was said of a logger that nobody holds. */
    private static final Logger LOGGER = Logger.getLogger("com.hazelcast");

    private Settings() {}

    /** What it has to say before it has read its settings, too: advice about Java's options. */
    private static void silence() {
        LOGGER.setLevel(Level.OFF);
    }

    /** Of the campaign. */
    static Config campaign(Meeting meeting) {
        silence();
        Config config = new Config();
        config.setClassLoader(Settings.class.getClassLoader());
        config.setClusterName(meeting.password());
        config.setProperty("hazelcast.logging.type", "none");
        config.setProperty("hazelcast.phone.home.enabled", "false");
        config.setProperty("hazelcast.socket.bind.any", "false");
        config.setProperty("hazelcast.shutdownhook.enabled", "false");
        config.setProperty("hazelcast.client.max.no.heartbeat.seconds", "" + SILENCE_SECONDS);
        config.getMetricsConfig().setEnabled(false);
        config.getJetConfig().setEnabled(false);
        config.getSerializationConfig().setJavaSerializationFilterConfig(nothing());
        NetworkConfig network = config.getNetworkConfig();
        network.setPort(meeting.port()).setPortAutoIncrement(false);
        network.getInterfaces().setEnabled(true).addInterface(meeting.host());
        network.setPublicAddress(meeting.address());
        network.getJoin().getAutoDetectionConfig().setEnabled(false);
        network.getJoin().getMulticastConfig().setEnabled(false);
        network.getJoin().getTcpIpConfig().setEnabled(false);
        return config;
    }

    /** What a stranger sends is never made an object of: letters are bytes. */
    private static JavaSerializationFilterConfig nothing() {
        return new JavaSerializationFilterConfig()
                .setDefaultsDisabled(true)
                .setWhitelist(new ClassFilter().addClasses("none"));
    }

    /** Of a worker, which ends when its campaign is gone. */
    static ClientConfig worker(Meeting meeting) {
        silence();
        ClientConfig config = new ClientConfig();
        config.setClassLoader(Settings.class.getClassLoader());
        config.setClusterName(meeting.password());
        config.setProperty("hazelcast.logging.type", "none");
        config.setProperty("hazelcast.client.heartbeat.interval", "2000");
        config.setProperty("hazelcast.client.heartbeat.timeout", "" + 1000 * SILENCE_SECONDS);
        config.setProperty("hazelcast.client.invocation.timeout.seconds", "" + SILENCE_SECONDS);
        config.setProperty("hazelcast.client.statistics.enabled", "false");
        config.getMetricsConfig().setEnabled(false);
        config.getSerializationConfig().setJavaSerializationFilterConfig(nothing());
        config.getNetworkConfig().addAddress(meeting.address());
        config.getNetworkConfig()
                .getClusterRoutingConfig()
                .setRoutingMode(RoutingMode.SINGLE_MEMBER);
        config.getConnectionStrategyConfig().setReconnectMode(ReconnectMode.OFF);
        config.getConnectionStrategyConfig()
                .getConnectionRetryConfig()
                .setInitialBackoffMillis(200)
                .setMaxBackoffMillis(1000)
                .setClusterConnectTimeoutMillis(3000);
        return config;
    }
}
