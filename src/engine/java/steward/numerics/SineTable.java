package steward.numerics;

/**
 * Table of sines and cosines of the 256 directions that divide a full turn, each in two parts: a multiple of 2^-26 and
 * a rest. The rest is the nearest double, at most 2^-27. Together they are within 2^-81 of the exact value. The short
 * first parts have exact products with other short numbers (see {@link SineCosine}).
 */
final class SineTable {

    /** Directions in a full turn. */
    static final int DIRECTIONS = 256;
    /** Numbers per direction: the two parts of the sine, then those of the cosine. */
    static final int NUMBERS = 4;

    private static final int QUARTER = DIRECTIONS / 4;

    /** sin(k pi / 128) for k from 0 to 64: first part, rest. Tests compute them anew. */
    private static final double[] FIRST_QUARTER = {
        0, 0, 0x1.92156p-6, -0x1.0b933040d8eb2p-31,
        0x1.91f66p-5, -0x1.de44fd832257ap-30, 0x1.2d5208p-4, 0x1.2ce19f5ccbeefp-28,
        0x1.917a6cp-4, -0x1.eb25ea0f138c7p-31, 0x1.f564e4p-4, 0x1.6a9730e344e09p-28,
        0x1.2c8106p-3, 0x1.d1cc27444c003p-28, 0x1.5e2144p-3, 0x1.22cff19531ff7p-29,
        0x1.8f8b84p-3, -0x1.cb2cfaa4da337p-30, 0x1.c0b826p-3, 0x1.4fc9ec5f943afp-28,
        0x1.f19f98p-3, -0x1.37a839542deefp-29, 0x1.111d26p-2, 0x1.58fb3bb049841p-29,
        0x1.294063p-2, -0x1.2a60fa574a369p-30, 0x1.4135c9p-2, 0x1.05d98050c97c5p-28,
        0x1.58f9a7p-2, 0x1.6ac7f73f8409p-28, 0x1.708853p-2, 0x1.f48b3d5da731p-31,
        0x1.87de2ap-2, 0x1.abaa58b469891p-28, 0x1.9ef794p-2, 0x1.d476c516da813p-29,
        0x1.b5d101p-2, -0x1.87a8cff5264eap-28, 0x1.cc66eap-2, -0x1.b38ee87a5ebc7p-28,
        0x1.e2b5d4p-2, -0x1.fe4271387c9dcp-28, 0x1.f8ba4ep-2, -0x1.01d951812ec2p-28,
        0x1.0738798p-1, 0x1.22ffed9697fafp-29, 0x1.11eb358p-1, -0x1.f25a6ebde476dp-28,
        0x1.1c73b38p-1, 0x1.ae68c86c9774ap-29, 0x1.26d055p-1, -0x1.917690abb4e88p-28,
        0x1.30ff8p-1, -0x1.8f47e58f7e631p-28, 0x1.3affa28p-1, 0x1.2050b93c7c4bcp-29,
        0x1.44cf328p-1, -0x1.7b7114f3fc4afp-28, 0x1.4e6cab8p-1, 0x1.f1f2f489e149fp-28,
        0x1.57d6938p-1, -0x1.b989b02eae413p-28, 0x1.610b758p-1, -0x1.7169909251b35p-28,
        0x1.6a09e68p-1, -0x1.80c4336f74d05p-29, 0x1.72d0838p-1, -0x1.00069bcac43c4p-33,
        0x1.7b5df2p-1, 0x1.3557d76f0ac85p-28, 0x1.83b0e08p-1, 0x1.ffcbb6e90bdfp-28,
        0x1.8bc8068p-1, 0x1.8a8ba05a743dap-28, 0x1.93a2248p-1, 0x1.9263fb4f5066ap-29,
        0x1.9b3e048p-1, -0x1.8f17e98771434p-34, 0x1.a29a7ap-1, 0x1.189e0776ba27fp-31,
        0x1.a9b6628p-1, 0x1.0ea1a3033ec62p-29, 0x1.b090a58p-1, 0x1.501ff9b64974p-33,
        0x1.b728348p-1, -0x1.7348e1378d3e6p-28, 0x1.bd7c0bp-1, -0x1.c8356b304b4e6p-28,
        0x1.c38b2fp-1, 0x1.80bdb0d23e9d1p-29, 0x1.c954b2p-1, 0x1.3411f4f68244fp-29,
        0x1.ced7af8p-1, -0x1.e19c46879edafp-28, 0x1.d4134dp-1, 0x1.4dc939ac42b5bp-29,
        0x1.d906bdp-1, -0x1.9ae573aea067cp-30, 0x1.ddb13b8p-1, -0x1.333dc39f0f20ep-29,
        0x1.e212108p-1, -0x1.84bc8da0298eep-28, 0x1.e6288fp-1, -0x1.db8f7708b5ab8p-28,
        0x1.e9f4158p-1, -0x1.39d225a27d387p-29, 0x1.ed740e8p-1, -0x1.2f6d3985f4e1cp-30,
        0x1.f0a7ef8p-1, 0x1.c9186b952c7aep-28, 0x1.f38f3bp-1, -0x1.cd8d3b9d7bafbp-28,
        0x1.f6297dp-1, -0x1.1469faa77a357p-34, 0x1.f8764f8p-1, 0x1.38a5d49ab2567p-28,
        0x1.fa7558p-1, -0x1.eeb5d2bd05465p-30, 0x1.fc2647p-1, 0x1.c33fa68f64334p-30,
        0x1.fd88dap-1, 0x1.e89292cf04139p-28, 0x1.fe9cdbp-1, -0x1.7f3be2f56f099p-28,
        0x1.ff621ep-1, 0x1.bcb6bef1d421fp-28, 0x1.ffd886p-1, 0x1.099a19765595dp-30,
        1, 0};

    /** Direction k has its numbers from 4 k on. */
    static double[] rows() {
        double[] rows = new double[NUMBERS * DIRECTIONS];
        for (int k = 0; k < DIRECTIONS; k++) {
            putSine(k, rows, NUMBERS * k);
            putSine((k + QUARTER) % DIRECTIONS, rows, NUMBERS * k + 2);
        }
        return rows;
    }

    private static void putSine(int k, double[] rows, int at) {
        int half = k % (2 * QUARTER);
        int mirrored = Math.min(half, 2 * QUARTER - half);
        double sign = k < 2 * QUARTER ? 1 : -1;
        rows[at] = sign * FIRST_QUARTER[2 * mirrored];
        rows[at + 1] = sign * FIRST_QUARTER[2 * mirrored + 1];
    }
}
