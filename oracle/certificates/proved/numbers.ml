(* SPDX-License-Identifier: Apache-2.0 *)
(* Numbers of a claim, as fractions of Coq, whose denominators are positive. *)
open Proved
module Z = Whole (* not the extracted module of that name *)

exception Refused of string

let refuse what rule = raise (Refused (what ^ ": " ^ rule))
let fraction top bottom = { qnum = top; qden = bottom }
let zero = fraction Z.zero Z.one
let minus q = fraction (Z.neg q.qnum) q.qden

(* odd * 2^power *)
let scaled odd power =
  if power >= 0 then fraction (Z.shift_left odd power) Z.one else fraction odd (Z.shift_left Z.one (-power))

let without_zeros top power =
  let zeros = Z.trailing_zeros top in
  (Z.shift_right top zeros, power + zeros)

let of_double value =
  let mantissa, exponent = Float.frexp value in
  let top = Z.of_float (Float.ldexp mantissa 53) in
  if Z.equal top Z.zero then zero
  else
    let odd, power = without_zeros top (exponent - 53) in
    scaled odd power

let hexadecimal_digit = function
  | '0' .. '9' as c -> Some (Char.code c - Char.code '0')
  | 'a' .. 'f' as c -> Some (Char.code c - Char.code 'a' + 10)
  | 'A' .. 'F' as c -> Some (Char.code c - Char.code 'A' + 10)
  | _ -> None

let all_digits text = text <> "" && String.for_all (fun c -> c >= '0' && c <= '9') text

(* "0x1.8p-3", with a sign or none: it has to be a binary64 number. *)
let of_hexadecimal what text =
  let malformed () = refuse what "a number or a hexadecimal float string" in
  let length = String.length text in
  let start = if length > 0 && (text.[0] = '-' || text.[0] = '+') then 1 else 0 in
  if length < start + 3 || text.[start] <> '0' || Char.lowercase_ascii text.[start + 1] <> 'x' then malformed ();
  let mantissa, power = match String.index_from_opt (String.lowercase_ascii text) start 'p' with
    | None -> (String.sub text (start + 2) (length - start - 2), 0)
    | Some p ->
        let signed = p + 1 < length && (text.[p + 1] = '-' || text.[p + 1] = '+') in
        let first = if signed then p + 2 else p + 1 in
        let digits = String.sub text first (length - first) in
        if not (all_digits digits && String.length digits <= 5) then malformed ();
        let power = int_of_string ("0u" ^ digits) in
        (String.sub text (start + 2) (p - start - 2), if signed && text.[p + 1] = '-' then -power else power) in
  let digits, places = match String.index_opt mantissa '.' with
    | None -> (mantissa, 0)
    | Some dot ->
        let after = String.sub mantissa (dot + 1) (String.length mantissa - dot - 1) in
        (String.sub mantissa 0 dot ^ after, String.length after) in
  if digits = "" || String.length digits > 1000 then malformed ();
  let add top c = match hexadecimal_digit c with
    | Some digit -> Z.add (Z.shift_left top 4) (Z.of_int digit)
    | None -> refuse what "a number or a hexadecimal float string" in
  let top = String.fold_left add Z.zero digits in
  if Z.equal top Z.zero then zero
  else begin
    let odd, power = without_zeros top (power - (4 * places)) in
    if Z.numbits odd > 53 || power < -1074 || power + Z.numbits odd > 1024 then refuse what "a binary64 number";
    scaled (if text.[0] = '-' then Z.neg odd else odd) power
  end

(* An input number. Decimal text is rounded to the nearest double. *)
let given what = function
  | Json.Number text -> of_double (float_of_string text)
  | Json.Text ("inf" | "-inf" | "nan") -> refuse what "finite number"
  | Json.Text text -> of_hexadecimal what text
  | _ -> refuse what "a number or a hexadecimal float string"

let longest = 100_000

(* "p/q" without a sign; `rule` is the one that another text breaks. *)
let of_digits what rule text =
  match String.split_on_char '/' text with
  | [ top ] when all_digits top -> fraction (Z.of_string_base 10 top) Z.one
  | [ top; bottom ] when all_digits top && all_digits bottom ->
      let bottom = Z.of_string_base 10 bottom in
      if Z.sign bottom = 0 then refuse what rule;
      fraction (Z.of_string_base 10 top) bottom
  | _ -> refuse what rule

let signed what rule text =
  if text <> "" && text.[0] = '-' then minus (of_digits what rule (String.sub text 1 (String.length text - 1)))
  else of_digits what rule text

let exact what = function
  | Json.Text text when String.length text <= longest -> signed what "an exact value \"p/q\"" text
  | _ -> refuse what "an exact value \"p/q\""

(* "p/q", or "p+q*sqrt(k)" with a natural number k; p and q* may be missing. *)
let surd what = function
  | Json.Text text when String.length text <= longest && String.contains text 's' ->
      let rule = "an exact value \"p/q\" or \"p+q*sqrt(r)\"" in
      let malformed () = refuse what rule in
      let root = String.index text 's' and length = String.length text in
      if length < root + 7 || String.sub text root 5 <> "sqrt(" || text.[length - 1] <> ')' then malformed ();
      let radicand = String.sub text (root + 5) (length - root - 6) in
      if not (all_digits radicand) then malformed ();
      let head = String.sub text 0 root in
      let place c = Option.value ~default:(-1) (String.rindex_opt head c) in
      let sign = max (place '+') (place '-') in
      if sign = 0 && head.[0] = '+' then malformed ();
      let part = if sign > 0 then signed what rule (String.sub head 0 sign) else zero in
      let factor = String.sub head (sign + 1) (root - sign - 1) in
      let size =
        if factor = "" then fraction Z.one Z.one
        else if factor.[String.length factor - 1] = '*' then
          of_digits what rule (String.sub factor 0 (String.length factor - 1))
        else refuse what rule in
      let negative = sign >= 0 && head.[sign] = '-' in
      Surd (part, (if negative then minus size else size), fraction (Z.of_string_base 10 radicand) Z.one)
  | value -> Surd (exact what value, zero, zero)
