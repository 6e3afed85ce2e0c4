package steward.machines.broker;

import java.net.Socket;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.util.Map;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509ExtendedTrustManager;
import org.apache.activemq.artemis.core.remoting.impl.netty.TransportConstants;
import org.apache.activemq.artemis.core.remoting.impl.ssl.DefaultSSLContextFactory;
import org.apache.activemq.artemis.spi.core.remoting.ssl.SSLContextConfig;
import steward.machines.token.BrokerKey;

/**
 * Factory of Artemis's TLS contexts. A connection with a fingerprint trusts exactly the key of that fingerprint, in any
 * certificate: names and dates are ignored, since clocks differ. The handshake proves that the other side has the
 * private key. Artemis finds it as a service.
 */
public final class PinnedContextFactory extends DefaultSSLContextFactory {

    /** Before the fingerprint, in the parameter that names a context. */
    static final String PIN = "pin:";
    private static final int FIRST = 100;

    /** Called by the service loader. */
    public PinnedContextFactory() {
        super();
    }

    @Override
    public int getPriority() {
        return FIRST;
    }

    @Override
    public SSLContext getSSLContext(SSLContextConfig config, Map<String, Object> options) throws Exception {
        Object name = options == null ? null : options.get(TransportConstants.SSL_CONTEXT_PROP_NAME);
        if (!(name instanceof String text) || !text.startsWith(PIN)) {
            return super.getSSLContext(config, options);
        }
        return context(text.substring(PIN.length()));
    }

    /** One that trusts the key of this fingerprint. */
    static SSLContext context(String fingerprint) throws GeneralSecurityException {
        SSLContext context = SSLContext.getInstance("TLSv1.3");
        context.init(null, new TrustManager[] {new Pinned(fingerprint)}, null);
        return context;
    }

    /** Trusts one key. */
    private static final class Pinned extends X509ExtendedTrustManager {

        private final String fingerprint;

        Pinned(String fingerprint) {
            this.fingerprint = fingerprint;
        }

        private void check(X509Certificate... chain) throws CertificateException {
            String found = chain.length == 0 ? "none" : BrokerKey.fingerprint(chain[0].getPublicKey());
            if (!found.equals(fingerprint)) {
                throw new CertificateException(BrokerClient.OTHER_KEY + ": found " + found + ", expected "
                    + fingerprint);
            }
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, Socket socket)
                throws CertificateException {
            check(chain);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, SSLEngine engine)
                throws CertificateException {
            check(chain);
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type) throws CertificateException {
            throw new CertificateException("there are no clients here");
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, Socket socket)
                throws CertificateException {
            throw new CertificateException("there are no clients here");
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, SSLEngine engine)
                throws CertificateException {
            throw new CertificateException("there are no clients here");
        }

        @Override
        public X509Certificate[] getAcceptedIssuers() {
            return new X509Certificate[0];
        }
    }
}
