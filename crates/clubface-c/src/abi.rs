/// Number of this interface; it grows with every change that a compiled caller would notice.
pub const CLUBFACE_ABI: u32 = 2;
